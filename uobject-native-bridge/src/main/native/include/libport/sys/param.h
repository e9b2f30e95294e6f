/// The header <sys/param.h> of the system.
#ifndef LIBPORT_SYS_PARAM_H
#define LIBPORT_SYS_PARAM_H

#include <sys/param.h>

#endif
