/// The header <netinet/in.h> of the system.
#ifndef LIBPORT_NETINET_IN_H
#define LIBPORT_NETINET_IN_H

#include <netinet/in.h>

#endif
