/// The header <fcntl.h> of the system.
#ifndef LIBPORT_FCNTL_H
#define LIBPORT_FCNTL_H

#include <fcntl.h>

#endif
