/// The numbers of urbiscript.
#ifndef LIBPORT_UFLOAT_HH
#define LIBPORT_UFLOAT_HH

#include <libport/ufloat.h>

#endif
