/// The header <netdb.h> of the system.
#ifndef LIBPORT_NETDB_H
#define LIBPORT_NETDB_H

#include <netdb.h>

#endif
