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
#define URBI_ENTRY_IF_USED extern "C" inline __declspec(dllexport)
#else
#define URBI_ENTRY extern "C" inline __attribute__((visibility("default"), used))
/// A function that is exported only by modules that call it.
#define URBI_ENTRY_IF_USED extern "C" inline __attribute__((visibility("default"), noinline))
#endif

/// The code of these headers stands in detail/code. It is compiled with each component that includes
/// them, so that they need no library. umake compiles it once for many components, which it tells so by
/// URBI_SEPARATE.
#ifdef URBI_SEPARATE
#define URBI_INLINE
#else
#define URBI_INLINE inline
#define URBI_HAS_CODE
#endif

/// A function that keeps state. It is called wherever it is used: in a module whose parts were compiled
/// in both ways there are several of it, of which the linker takes one for all.
#define URBI_STATE URBI_INLINE ATTRIBUTE_NOINLINE

#endif
