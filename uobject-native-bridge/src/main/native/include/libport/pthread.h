/// The header <pthread.h> of the system.
#ifndef LIBPORT_PTHREAD_H
#define LIBPORT_PTHREAD_H

#include <pthread.h>

#endif
