/// What is visible of a module from outside. Nothing but its entry points has to be: the functions
/// that keep state are hidden, so that a module has its own state and can be unloaded again
/// (an exported static variable of an inline function would be unique in the whole process).
#ifndef URBI_EXPORT_HH
#define URBI_EXPORT_HH

#include <libport/compiler.hh>

#define URBI_SDK_API

#define URBI_LOCAL LIBPORT_LOCAL

#if defined _WIN32
#define URBI_ENTRY extern "C" inline __declspec(dllexport)
#else
#define URBI_ENTRY extern "C" inline __attribute__((visibility("default"), used))
#endif

#endif
