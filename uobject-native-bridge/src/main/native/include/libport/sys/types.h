/// The header <sys/types.h> of the system.
#ifndef LIBPORT_SYS_TYPES_H
#define LIBPORT_SYS_TYPES_H

#include <sys/types.h>

#endif
