/// Loops over containers.
#ifndef LIBPORT_FOREACH_HH
#define LIBPORT_FOREACH_HH

#include <iterator>
#include <utility>

/// foreach (const T& each, container): one turn for each element.
#define foreach(Variable, ...) for (Variable : __VA_ARGS__)

/// The same from the end.
#define rforeach(Variable, ...) for (Variable : ::libport::detail::backwards(__VA_ARGS__))

namespace libport
{
  namespace detail
  {
    template <typename Container>
    struct Backwards
    {
      auto begin() const -> decltype(std::declval<Container&>().rbegin())
      {
        return all.rbegin();
      }

      auto end() const -> decltype(std::declval<Container&>().rend())
      {
        return all.rend();
      }

      Container& all;
    };

    template <typename Container>
    Backwards<Container> backwards(Container& all)
    {
      return Backwards<Container>{all};
    }
  }
}

#endif
