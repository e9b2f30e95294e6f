/// The header <sys/stat.h> of the system.
#ifndef LIBPORT_SYS_STAT_H
#define LIBPORT_SYS_STAT_H

#include <sys/stat.h>

#endif
