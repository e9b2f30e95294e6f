/// Containers that may change while they are gone through.
#ifndef LIBPORT_SAFE_CONTAINER_HH
#define LIBPORT_SAFE_CONTAINER_HH

#include <memory>

namespace libport
{
  /// What goes through it sees the elements that it had at that moment.
  template <template <typename, typename> class Container, typename T>
  class SafeContainer : public Container<T, std::allocator<T>>
  {
  public:
    typedef Container<T, std::allocator<T>> super_type;
    using super_type::super_type;
    SafeContainer() = default;

    /// Its elements now.
    super_type snapshot() const
    {
      return *this;
    }
  };
}

#endif
