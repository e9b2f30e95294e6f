/// A main of one's own with a user interface by Qt: `UMAIN();`. Qt has the main thread; the functions of
/// the UObjects are called on another, so what they do to widgets they have to ask Qt for, by a queued
/// signal for instance.
#ifndef URBI_QT_UMAIN_HH
#define URBI_QT_UMAIN_HH

#include <libport/unistd.h>

#include <urbi/umain.hh>
#include <urbi/usyncclient.hh>

#include <QApplication>
#include <QObject>

#undef UMAIN
#define UMAIN()                                                                                          \
  int main(int argc, char* argv[])                                                                       \
  {                                                                                                      \
    if (int status = urbi::main(argc, const_cast<const char**>(argv), false))                            \
      return status;                                                                                     \
    QApplication application(argc, argv);                                                                \
    return application.exec();                                                                           \
  }

#endif
