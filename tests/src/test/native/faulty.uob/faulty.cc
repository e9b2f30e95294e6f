// A module with every fault that a module can have.
#include <urbi/uobject.hh>
#include <urbi/uclient.hh>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>
#include <unistd.h>

namespace
{
  void crash()
  {
    int* volatile nowhere = nullptr;
    *nowhere = 1;
  }

  void spin()
  {
    for (volatile unsigned i = 0;; ++i)
      ;
  }

  /// The same library under other names fails when it is loaded.
  struct Loaded
  {
    Loaded()
    {
      Dl_info where;
      dladdr(reinterpret_cast<void*>(&crash), &where);
      if (strstr(where.dli_fname, "crashes-early"))
        crash();
      if (strstr(where.dli_fname, "spins-early"))
        spin();
      if (strstr(where.dli_fname, "exits-early"))
        exit(4);
    }
  };

  Loaded loaded;
  bool doomed = false;
}

class Faulty : public urbi::UObject
{
public:
  Faulty(const std::string& s)
    : urbi::UObject(s)
  {
    if (doomed)
      crash();
    UBindVars(Faulty, v, twice);
    UBindEvent(Faulty, hit);
    UBindFunctions(Faulty, init, add, segfault, aborts, exits, spins, rests, writes, chatters,
                   crashLater, tick, doom, hasClient, process);
    UNotifyChange(v, &Faulty::changed);
    v = 0;
  }

  int init()
  {
    return 0;
  }

  double add(double a, double b)
  {
    return a + b;
  }

  /// Whether there is a server for clients of its own.
  bool hasClient()
  {
    return urbi::getDefaultClient();
  }

  /// The number of the process in which it runs.
  std::string process()
  {
    return std::to_string(getpid());
  }

  void segfault()
  {
    fprintf(stderr, "about to fall\n");
    crash();
  }

  void aborts()
  {
    fprintf(stderr, "no way on\n");
    abort();
  }

  void exits(int status)
  {
    exit(status);
  }

  void spins()
  {
    spin();
  }

  double rests(double milliseconds)
  {
    usleep(static_cast<useconds_t>(milliseconds * 1000));
    return milliseconds;
  }

  /// Bytes of all kinds on what is not its own.
  void writes(int kilobytes)
  {
    for (int i = 0; i < kilobytes * 1024; ++i)
      putchar(i * 7 % 256);
    fflush(stdout);
  }

  void chatters(const std::string& text)
  {
    puts(text.c_str());
    fflush(stdout);
  }

  void crashLater(double milliseconds)
  {
    USetTimer(milliseconds, &Faulty::fall);
  }

  void tick(double milliseconds)
  {
    USetTimer(milliseconds, &Faulty::count);
  }

  void doom()
  {
    doomed = true;
  }

  void changed()
  {
    twice = 2 * static_cast<double>(v);
    hit.emit(static_cast<double>(v));
  }

  int fall()
  {
    crash();
    return 0;
  }

  int count()
  {
    v = static_cast<double>(v) + 1;
    return 0;
  }

  urbi::UVar v, twice;
  urbi::UEvent hit;
};

UStart(Faulty);
