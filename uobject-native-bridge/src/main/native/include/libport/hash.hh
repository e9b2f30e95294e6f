/// Containers that are searched by hash values.
#ifndef LIBPORT_HASH_HH
#define LIBPORT_HASH_HH

#include <libport/boost-names.hh>

#endif
