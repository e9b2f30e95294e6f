/// The header <sys/utsname.h> of the system.
#ifndef LIBPORT_SYS_UTSNAME_H
#define LIBPORT_SYS_UTSNAME_H

#include <sys/utsname.h>

#endif
