/// The header <arpa/inet.h> of the system.
#ifndef LIBPORT_ARPA_INET_H
#define LIBPORT_ARPA_INET_H

#include <arpa/inet.h>

#endif
