/// What a shared library of this layer would export: it is in headers alone.
#ifndef LIBPORT_EXPORT_HH
#define LIBPORT_EXPORT_HH

#include <libport/compiler.hh>

#define LIBPORT_API

#endif
