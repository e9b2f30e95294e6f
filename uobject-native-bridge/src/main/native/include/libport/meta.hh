/// Questions to types.
#ifndef LIBPORT_META_HH
#define LIBPORT_META_HH

#include <type_traits>

namespace libport
{
  namespace meta
  {
    typedef std::true_type True;
    typedef std::false_type False;

    template <bool Condition, typename Then = True, typename Else = False>
    struct If
    {
      typedef typename std::conditional<Condition, Then, Else>::type res;
    };

    template <typename Derived, typename Base>
    struct Inherits
    {
      static const bool res = std::is_base_of<Base, Derived>::value;
    };

    template <typename Left, typename Right>
    struct Eq
    {
      static const bool res = std::is_same<Left, Right>::value;
    };
  }
}

#endif
