/// What urbi/uvar.hh declares.
// Before anything else: that header includes this one where it needs it.
#include <urbi/uvar.hh>

#ifndef URBI_UVAR_HXX
#define URBI_UVAR_HXX

#include <limits>

namespace urbi
{
  // ---------------------------------------------------------------- binding

  inline UVar::UVar()
    : owned(false)
    , rangemin(*this, PROP_RANGEMIN)
    , rangemax(*this, PROP_RANGEMAX)
    , speedmin(*this, PROP_SPEEDMIN)
    , speedmax(*this, PROP_SPEEDMAX)
    , delta(*this, PROP_DELTA)
    , blend(*this, PROP_BLEND)
    , constant(*this, PROP_CONSTANT)
    , slot_(-1)
    , temp_(false)
    , rtp_(RTP_DEFAULT)
  {}

  inline UVar::UVar(const std::string& name, impl::UContextImpl* context)
    : UVar()
  {
    init(name, context);
  }

  inline UVar::UVar(const std::string& object, const std::string& slot,
                    impl::UContextImpl* context)
    : UVar()
  {
    init(object, slot, context);
  }

  inline UVar::UVar(const UVar& other)
    : UVar()
  {
    port_ = other.port_;
    if (other.slot_ != -1)
      init(other.name_, other.ctx_);
  }

  inline UVar::~UVar()
  {
    close();
  }

  inline void UVar::init(const std::string& name, impl::UContextImpl* context)
  {
    if (context)
      ctx_ = context;
    bind(name);
  }

  inline void UVar::init(const std::string& object, const std::string& slot,
                         impl::UContextImpl* context)
  {
    init(object + "." + slot, context);
  }

  inline void UVar::bind(const std::string& name)
  {
    detail::Request request(URBI_VARIABLE, context());
    request.out.text(name);
    request.out.raw(static_cast<int64_t>(port_));
    int64_t slot = request.send();
    close();
    slot_ = slot;
    name_ = name;
    owned = false;
  }

  inline void UVar::close() noexcept
  {
    if (slot_ == -1)
      return;
    try
    {
      detail::Request(URBI_VARIABLE_CLOSE, context(), slot_).send();
    }
    catch (const std::exception&)
    {
      // The host has gone, and the variable with it.
    }
    slot_ = -1;
  }

  inline void UVar::check() const
  {
    if (slot_ == -1)
      throw std::runtime_error("invalid use of unbound UVar");
  }

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

  inline void UVar::write(const UValue& value)
  {
    check();
    detail::Request request(URBI_VARIABLE_SET, context(), slot_);
    request.out.value(value);
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

  inline UVar& UVar::operator=(const UVar& other)
  {
    UValue value;
    {
      detail::Request request(URBI_VARIABLE_GET, other.context(), other.slot_);
      other.read(request).reply().value(value);
    }
    write(value);
    return *this;
  }

  inline void UVar::reset(ufloat value)
  {
    check();
    detail::Request request(URBI_VARIABLE_SET, context(), slot_);
    request.out.number(value);
    request.send();
  }

  // ---------------------------------------------------------------- reading

  inline detail::Request& UVar::read(detail::Request& request) const
  {
    check();
    request.send();
    return request;
  }

  inline void UVar::tell(detail::Reader& in)
  {
    std::lock_guard<std::mutex> guard(lock_);
    in.value(kept());
  }

  inline UValue& UVar::kept() const
  {
    std::thread::id self = std::this_thread::get_id();
    if (first_ == std::thread::id())
      first_ = self;
    return first_ == self ? value_ : others_[self];
  }

  inline UValue& UVar::own() const
  {
    std::lock_guard<std::mutex> guard(lock_);
    return kept();
  }

  inline bool UVar::is_told() const
  {
    for (const detail::Told* at = detail::thread_state().told; at; at = at->outer)
      if (at->variable == this)
        return true;
    return false;
  }

  inline const UValue& UVar::val() const
  {
    if (is_told())
      return own();
    UValue read_now;
    detail::Request request(URBI_VARIABLE_GET, context(), slot_);
    read(request).reply().value(read_now);
    // A reference to it stays good while other threads read.
    std::lock_guard<std::mutex> guard(lock_);
    return kept() = std::move(read_now);
  }

  inline const UValue& UVar::operator*() const
  {
    return val();
  }

  inline UDataType UVar::type() const
  {
    return val().type;
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

  inline UVar::operator std::string() const
  {
    return as<std::string>();
  }

  inline UVar::operator const UBinary&() const
  {
    return val();
  }

  inline UVar::operator UBinary*() const
  {
    return new UBinary(static_cast<const UBinary&>(val()));
  }

  inline UVar::operator UImage() const
  {
    return val();
  }

  inline UVar::operator USound() const
  {
    return val();
  }

  inline UVar::operator UList() const
  {
    return as<UList>();
  }

  inline UVar::operator UDictionary() const
  {
    return as<UDictionary>();
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

  inline ufloat UVar::in() const
  {
    detail::Request request(URBI_VARIABLE_IN, context(), slot_);
    return read(request).reply().raw<ufloat>();
  }

  inline ufloat UVar::out() const
  {
    detail::Request request(URBI_VARIABLE_OUT, context(), slot_);
    return read(request).reply().raw<ufloat>();
  }

  inline utime_t UVar::timestamp() const
  {
    check();
    return detail::Request(URBI_VARIABLE_TIME, context(), slot_).send();
  }

  // ---------------------------------------------------------------- what becomes of it

  inline void UVar::setOwned()
  {
    check();
    detail::Request(URBI_VARIABLE_OWN, context(), slot_).send();
    owned = true;
  }

  inline void UVar::syncValue()
  {
    UValue read_now;
    detail::Request request(URBI_VARIABLE_SYNC, context(), slot_);
    read(request).reply().value(read_now);
    std::lock_guard<std::mutex> guard(lock_);
    kept() = std::move(read_now);
  }

  inline void UVar::keepSynchronized()
  {
    check();
    detail::Request(URBI_VARIABLE_KEEP, context(), slot_).send();
  }

  inline void UVar::unnotify()
  {
    check();
    detail::Request(URBI_VARIABLE_UNNOTIFY, context(), slot_).send();
  }

  inline bool UVar::setBypass(bool enable)
  {
    check();
    detail::Request request(URBI_VARIABLE_BYPASS, context(), slot_);
    request.out.raw(static_cast<int64_t>(enable));
    return request.send() != 0;
  }

  inline void UVar::useRTP(bool enable)
  {
    check();
    rtp_ = enable ? RTP_YES : RTP_NO;
    detail::Request request(URBI_VARIABLE_RTP, context(), slot_);
    request.out.raw(static_cast<int64_t>(enable));
    request.send();
  }

  inline UValue UVar::getProp(UProperty property) const
  {
    detail::Request request(URBI_VARIABLE_GET_PROPERTY, context(), slot_);
    request.out.raw(static_cast<int64_t>(property));
    UValue value;
    read(request).reply().value(value);
    return value;
  }

  inline void UVar::setProp(UProperty property, const UValue& value)
  {
    check();
    detail::Request request(URBI_VARIABLE_SET_PROPERTY, context(), slot_);
    request.out.raw(static_cast<int64_t>(property));
    request.out.value(value);
    request.send();
  }

  inline void UVar::setProp(UProperty property, ufloat value)
  {
    setProp(property, UValue(value));
  }

  inline void UVar::setProp(UProperty property, const char* value)
  {
    setProp(property, UValue(value));
  }

  inline void UVar::setProp(UProperty property, const std::string& value)
  {
    setProp(property, UValue(value));
  }

  inline std::ostream& operator<<(std::ostream& out, const UVar& variable)
  {
    return out << variable.val();
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

#endif
