/// What urbi/uvar.hh declares.
// Before anything else: that header includes this one where it needs it.
#include <urbi/uvar.hh>

#ifndef URBI_UVAR_HXX
#define URBI_UVAR_HXX

#include <limits>

namespace urbi
{
  // ---------------------------------------------------------------- writing

  template <typename T>
  void UVar::write_binary(const T& value)
  {
    check();
    detail::Request request(URBI_VARIABLE_SET, context(), slot_);
    // The kernel copies the data where it has to.
    if constexpr (std::is_same<T, UBinary>::value)
      request.out.binary(value);
    else
      request.out.binary(UBinary(value, false));
    request.send();
  }

  template <typename T>
  UVar& UVar::operator=(const T& value)
  {
    if constexpr (std::is_arithmetic<T>::value)
      reset(static_cast<ufloat>(value));
    else if constexpr (std::is_base_of<UVar, T>::value)
      *this = static_cast<const UVar&>(value);
    else if constexpr (std::is_same<T, UValue>::value)
      write(value);
    else if constexpr (std::is_same<T, UBinary>::value || std::is_same<T, UImage>::value
                       || std::is_same<T, USound>::value)
      write_binary(value);
    else
    {
      UValue made;
      made = value;
      write(made);
    }
    return *this;
  }

  // ---------------------------------------------------------------- reading

  inline bool UVar::is_told() const
  {
    for (const detail::Told* at = detail::thread_state().told; at; at = at->outer)
      if (at->variable == this)
        return true;
    return false;
  }

  template <typename T>
  T UVar::as() const
  {
    if constexpr (std::is_same<T, UImage>::value || std::is_same<T, USound>::value)
      return static_cast<T>(val());
    else if (is_told())
      return uvalue_cast<T>(own());
    else
    {
      UValue value;
      detail::Request request(URBI_VARIABLE_GET, context(), slot_);
      read(request).reply().value(value);
      return uvalue_cast<T>(value);
    }
  }

  template <typename T>
  T UVar::as(T*) const
  {
    return as<T>();
  }

  template <typename T>
  T& UVar::fill(T& object) const
  {
    return object = as<T>();
  }

  template <typename T, UVar::if_number<T>>
  UVar::operator T() const
  {
    if (is_told())
      return static_cast<T>(own());
    detail::Request request(URBI_VARIABLE_GET, context(), slot_);
    detail::Reader reply = read(request).reply();
    ufloat number;
    if (reply.number(number))
      return detail::to_number<T>(number);
    UValue value;
    reply.value(value);
    return static_cast<T>(value);
  }

  template <typename T>
  bool UVar::operator==(const T& other) const
  {
    if constexpr (std::is_base_of<UVar, T>::value)
      return detail::literal_of(val()) == detail::literal_of(other.val());
    else if constexpr (std::is_arithmetic<T>::value)
      return static_cast<ufloat>(*this) == static_cast<ufloat>(other);
    else if constexpr (std::is_convertible<const T&, std::string>::value)
      return static_cast<std::string>(*this) == static_cast<std::string>(other);
    else
      return as<T>() == other;
  }

  template <typename T>
  bool UVar::operator!=(const T& other) const
  {
    return !(*this == other);
  }

  // ---------------------------------------------------------------- arithmetic

  namespace detail
  {
    template <typename T>
    using is_variable = std::is_base_of<UVar, T>;

    /// Whether one side is a variable and the other a variable or a number.
    template <typename L, typename R>
    using if_operands = std::enable_if_t<(is_variable<L>::value
                                          && (is_variable<R>::value || std::is_arithmetic<R>::value))
                                           || (std::is_arithmetic<L>::value
                                               && is_variable<R>::value),
                                         int>;
  }

#define URBI_OPERATOR_(Result, Operator)                                                          \
  template <typename L, typename R, detail::if_operands<L, R> = 0>                                \
  Result operator Operator(const L& left, const R& right)                                         \
  {                                                                                               \
    return static_cast<ufloat>(left) Operator static_cast<ufloat>(right);                         \
  }

  URBI_OPERATOR_(ufloat, +)
  URBI_OPERATOR_(ufloat, -)
  URBI_OPERATOR_(ufloat, *)
  URBI_OPERATOR_(ufloat, /)
  URBI_OPERATOR_(bool, <)
  URBI_OPERATOR_(bool, >)
  URBI_OPERATOR_(bool, <=)
  URBI_OPERATOR_(bool, >=)
#undef URBI_OPERATOR_

  // ---------------------------------------------------------------- UProp

  inline UProp& UProp::operator=(const UValue& v)
  {
    owner.setProp(name, v);
    return *this;
  }

  inline UProp& UProp::operator=(ufloat v)
  {
    owner.setProp(name, v);
    return *this;
  }

  inline UProp& UProp::operator=(const std::string& v)
  {
    owner.setProp(name, v);
    return *this;
  }

  inline UProp& UProp::operator=(const char* v)
  {
    owner.setProp(name, v);
    return *this;
  }

  inline UProp& UProp::operator=(UBlendType v)
  {
    owner.setProp(name, urbi::name(v));
    return *this;
  }

  inline UProp::operator ufloat() const
  {
    return owner.getProp(name);
  }

  inline UProp::operator std::string() const
  {
    return owner.getProp(name);
  }

  inline UProp::operator UValue() const
  {
    return owner.getProp(name);
  }
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/uvar.hh>
#endif

#endif
