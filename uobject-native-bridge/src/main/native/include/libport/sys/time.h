/// The header <sys/time.h> of the system.
#ifndef LIBPORT_SYS_TIME_H
#define LIBPORT_SYS_TIME_H

#include <sys/time.h>

#endif
