/// Questions to types.
#ifndef LIBPORT_TRAITS_HH
#define LIBPORT_TRAITS_HH

#include <type_traits>

namespace libport
{
  namespace traits
  {
    using std::add_const;
    using std::add_pointer;
    using std::is_reference;
    using std::remove_const;
    using std::remove_pointer;
    using std::remove_reference;
  }
}

#endif
