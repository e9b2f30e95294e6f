/// The header <dirent.h> of the system.
#ifndef LIBPORT_DIRENT_H
#define LIBPORT_DIRENT_H

#include <dirent.h>

#endif
