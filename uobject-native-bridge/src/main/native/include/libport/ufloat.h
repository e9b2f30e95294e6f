/// The numbers of urbiscript.
#ifndef LIBPORT_UFLOAT_H
#define LIBPORT_UFLOAT_H

#include <cmath>
#include <limits>

namespace libport
{
  typedef double ufloat;

  const ufloat UFLOAT_MAX = std::numeric_limits<ufloat>::max();
  const ufloat UFLOAT_MIN = std::numeric_limits<ufloat>::min();
}

/// Components of 2.7 name it without a namespace.
typedef double ufloat;

#endif
