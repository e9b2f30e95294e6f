/// The header <sys/wait.h> of the system.
#ifndef LIBPORT_SYS_WAIT_H
#define LIBPORT_SYS_WAIT_H

#include <sys/wait.h>

#endif
