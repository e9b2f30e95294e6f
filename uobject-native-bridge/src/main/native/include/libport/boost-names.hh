/// The names of Boost that the headers of 2.7 brought along.
#ifndef LIBPORT_BOOST_NAMES_HH
#define LIBPORT_BOOST_NAMES_HH

#include <functional>
#include <memory>
#include <system_error>
#include <unordered_map>
#include <unordered_set>

// A using directive gives way: where a component includes Boost itself, Boost's own names win.
namespace libport
{
  namespace boost_names
  {
    using std::bind;
    using std::const_pointer_cast;
    using std::cref;
    using std::dynamic_pointer_cast;
    using std::enable_shared_from_this;
    using std::function;
    using std::hash;
    using std::make_shared;
    using std::mem_fn;
    using std::ref;
    using std::shared_ptr;
    using std::static_pointer_cast;
    using std::unordered_map;
    using std::unordered_multimap;
    using std::unordered_multiset;
    using std::unordered_set;
    using std::weak_ptr;

    namespace system
    {
      using std::error_code;
    }

    template <typename T>
    using scoped_ptr = std::unique_ptr<T>;

    template <typename R>
    using function0 = std::function<R()>;
    template <typename R, typename A>
    using function1 = std::function<R(A)>;
    template <typename R, typename A, typename B>
    using function2 = std::function<R(A, B)>;
    template <typename R, typename A, typename B, typename C>
    using function3 = std::function<R(A, B, C)>;
    template <typename R, typename A, typename B, typename C, typename D>
    using function4 = std::function<R(A, B, C, D)>;
    template <typename R, typename A, typename B, typename C, typename D, typename E>
    using function5 = std::function<R(A, B, C, D, E)>;
  }
}

namespace boost
{
  using namespace ::libport::boost_names;
}

#endif
