/// The header <unistd.h> of the system.
#ifndef LIBPORT_UNISTD_H
#define LIBPORT_UNISTD_H

#include <sys/types.h>
#include <unistd.h>

#endif
