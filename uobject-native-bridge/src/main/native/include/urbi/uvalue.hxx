/// What urbi/uvalue.hh and urbi/ulist.hh declare, and the casters.
// Before anything else: that header includes this one where it needs it.
#include <urbi/uvalue.hh>

#ifndef URBI_UVALUE_HXX
#define URBI_UVALUE_HXX

#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

#include <urbi/detail/literal.hh>

namespace urbi
{
  // ---------------------------------------------------------------- UList

  template <typename T>
  UList& UList::operator=(const T& container)
  {
    UList made;
    for (const auto& element : container)
      made.push_back(element);
    return *this = std::move(made);
  }

  template <typename T>
  T UList::as() const
  {
    UValue all(*this);
    return uvalue_cast<T>(all);
  }

  inline UList::iterator UList::begin()
  {
    return array.begin() + static_cast<std::ptrdiff_t>(offset);
  }

  inline UList::iterator UList::end()
  {
    return array.end();
  }

  inline UList::const_iterator UList::begin() const
  {
    return array.begin() + static_cast<std::ptrdiff_t>(offset);
  }

  inline UList::const_iterator UList::end() const
  {
    return array.end();
  }

  template <typename T>
  UList& UList::push_back(const T& element)
  {
    array.reserve(array.size() + 1);
    UValue made;
    made = element;
    array.push_back(new UValue(std::move(made)));
    return *this;
  }

  inline size_t UList::size() const
  {
    return array.size() - offset;
  }

  // ---------------------------------------------------------------- errors

  namespace detail
  {
    /// The value as an urbiscript literal.
    std::string literal_of(const UValue& value);

    /// What is shown of a value in a message.
    std::string brief(const UValue& value);

    /// The type of whole numbers, for people.
    template <typename T>
    std::string integer_name()
    {
      return (std::is_signed<T>::value ? "int" : "unsigned int") + std::to_string(8 * sizeof(T));
    }

    [[noreturn]] void bad_cast(const char* type, const UValue& value);
  }

  // ---------------------------------------------------------------- UValue

  inline UValue::UValue()
    : type(DATA_VOID)
    , val(0)
    , storage(nullptr)
  {}

  inline UValue::UValue(UValue&& other) noexcept
    : UValue()
  {
    steal(other);
  }

  inline UValue::~UValue()
  {
    clear();
  }

  template <typename T, UValue::if_number<T>>
  UValue::UValue(T number, bool)
    : type(DATA_DOUBLE)
    , val(static_cast<ufloat>(number))
    , storage(nullptr)
  {}

  inline UValue& UValue::operator=(UValue&& other) noexcept
  {
    if (this != &other)
    {
      clear();
      steal(other);
    }
    return *this;
  }

  inline void UValue::steal(UValue& other) noexcept
  {
    type = other.type;
    val = other.val;
    storage = other.storage;
    other.type = DATA_VOID;
    other.storage = nullptr;
  }

  namespace detail
  {
    /// A number in another type, without its decimals.
    ///
    /// \throw std::runtime_error if it is too large or too small for that
    template <typename T>
    T to_number(ufloat value)
    {
      if constexpr (std::is_same<T, bool>::value)
        return value != 0;
      else if constexpr (std::is_floating_point<T>::value)
        return static_cast<T>(value);
      else
      {
        // The largest number may be none of the doubles: the one above it is.
        typedef std::numeric_limits<T> limits;
        ufloat whole = std::trunc(value);
        if (!(whole >= static_cast<ufloat>(limits::min())
              && whole < std::ldexp(ufloat(1), limits::digits)))
          throw std::runtime_error("invalid cast to " + integer_name<T>() + " from "
                                   + number_text(value) + ": out of range");
        return static_cast<T>(whole);
      }
    }
  }

  template <typename T, UValue::if_number<T>>
  UValue::operator T() const
  {
    return detail::to_number<T>(number());
  }
}

#include <urbi/detail/casters.hh>

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/uvalue.hh>
#endif

#endif
