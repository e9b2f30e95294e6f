/// The header <sys/socket.h> of the system.
#ifndef LIBPORT_SYS_SOCKET_H
#define LIBPORT_SYS_SOCKET_H

#include <sys/socket.h>

#endif
