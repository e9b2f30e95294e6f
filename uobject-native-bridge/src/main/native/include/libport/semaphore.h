/// The header <semaphore.h> of the system.
#ifndef LIBPORT_SEMAPHORE_H
#define LIBPORT_SEMAPHORE_H

#include <semaphore.h>

#endif
