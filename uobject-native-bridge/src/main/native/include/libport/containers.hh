/// Common questions to containers.
#ifndef LIBPORT_CONTAINERS_HH
#define LIBPORT_CONTAINERS_HH

#include <algorithm>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include <libport/boost-names.hh>

namespace libport
{
  namespace detail
  {
    template <typename Container, typename T>
    auto find_in(Container& all, const T& wanted, int) -> decltype(all.find(wanted))
    {
      return all.find(wanted);
    }

    template <typename Container, typename T>
    auto find_in(Container& all, const T& wanted, long) -> decltype(all.begin())
    {
      return std::find(all.begin(), all.end(), wanted);
    }
  }

  /// Where an element, or the entry of a key, is.
  template <typename Container, typename T>
  auto find(Container& all, const T& wanted) -> decltype(all.begin())
  {
    return detail::find_in(all, wanted, 0);
  }

  /// Whether there is such an element or key.
  template <typename Container, typename T>
  bool has(const Container& all, const T& wanted)
  {
    return detail::find_in(all, wanted, 0) != all.end();
  }

  /// The same of a container with keys.
  template <typename Container, typename Key>
  bool mhas(const Container& all, const Key& wanted)
  {
    return all.find(wanted) != all.end();
  }

  /// The pointer that belongs to a key, or null.
  template <typename Container, typename Key>
  typename Container::mapped_type find0(const Container& all, const Key& wanted)
  {
    auto found = all.find(wanted);
    return found == all.end() ? typename Container::mapped_type() : found->second;
  }

  /// Deletes what a container points to, and empties it.
  template <typename Container>
  void deep_clear(Container& all)
  {
    for (auto* each : all)
      delete each;
    all.clear();
  }

  template <typename Container, typename Predicate>
  void erase_if(Container& all, const Predicate& wanted)
  {
    for (auto at = all.begin(); at != all.end();)
      if (wanted(*at))
        at = all.erase(at);
      else
        ++at;
  }

  template <typename Container, typename Function>
  Function for_each(Container& all, Function function)
  {
    return std::for_each(all.begin(), all.end(), function);
  }

  template <typename Container, typename Predicate>
  bool any(const Container& all, const Predicate& predicate)
  {
    return std::find_if(all.begin(), all.end(), predicate) != all.end();
  }

  template <typename Container, typename Predicate>
  bool all(const Container& all, const Predicate& predicate)
  {
    for (const auto& each : all)
      if (!predicate(each))
        return false;
    return true;
  }
}

#endif
