/// What urbi/uvar.hh declares: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/uvar.hh>

#ifndef URBI_DETAIL_CODE_UVAR_HH
#define URBI_DETAIL_CODE_UVAR_HH

namespace urbi
{
  // ---------------------------------------------------------------- binding

  URBI_INLINE UVar::UVar()
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

  URBI_INLINE UVar::UVar(const std::string& name, impl::UContextImpl* context)
    : UVar()
  {
    init(name, context);
  }

  URBI_INLINE UVar::UVar(const std::string& object, const std::string& slot,
                    impl::UContextImpl* context)
    : UVar()
  {
    init(object, slot, context);
  }

  URBI_INLINE UVar::UVar(const UVar& other)
    : UVar()
  {
    port_ = other.port_;
    if (other.slot_ != -1)
      init(other.name_, other.ctx_);
  }

  URBI_INLINE UVar::~UVar()
  {
    close();
  }

  URBI_INLINE void UVar::init(const std::string& name, impl::UContextImpl* context)
  {
    if (context)
      ctx_ = context;
    bind(name);
  }

  URBI_INLINE void UVar::init(const std::string& object, const std::string& slot,
                         impl::UContextImpl* context)
  {
    init(object + "." + slot, context);
  }

  URBI_INLINE void UVar::bind(const std::string& name)
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

  URBI_INLINE void UVar::close() noexcept
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

  URBI_INLINE void UVar::check() const
  {
    if (slot_ == -1)
      throw std::runtime_error("invalid use of unbound UVar");
  }

  // ---------------------------------------------------------------- writing

  URBI_INLINE void UVar::write(const UValue& value)
  {
    check();
    detail::Request request(URBI_VARIABLE_SET, context(), slot_);
    request.out.value(value);
    request.send();
  }

  URBI_INLINE UVar& UVar::operator=(const UVar& other)
  {
    UValue value;
    {
      detail::Request request(URBI_VARIABLE_GET, other.context(), other.slot_);
      other.read(request).reply().value(value);
    }
    write(value);
    return *this;
  }

  URBI_INLINE void UVar::reset(ufloat value)
  {
    check();
    detail::Request request(URBI_VARIABLE_SET, context(), slot_);
    request.out.number(value);
    request.send();
  }

  // ---------------------------------------------------------------- reading

  URBI_INLINE detail::Request& UVar::read(detail::Request& request) const
  {
    check();
    request.send();
    return request;
  }

  URBI_INLINE void UVar::tell(detail::Reader& in)
  {
    std::lock_guard<std::mutex> guard(lock_);
    in.value(kept());
  }

  URBI_INLINE UValue& UVar::kept() const
  {
    std::thread::id self = std::this_thread::get_id();
    if (first_ == std::thread::id())
      first_ = self;
    return first_ == self ? value_ : others_[self];
  }

  URBI_INLINE UValue& UVar::own() const
  {
    std::lock_guard<std::mutex> guard(lock_);
    return kept();
  }

  URBI_INLINE const UValue& UVar::val() const
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

  URBI_INLINE const UValue& UVar::operator*() const
  {
    return val();
  }

  URBI_INLINE UDataType UVar::type() const
  {
    return val().type;
  }

  URBI_INLINE UVar::operator std::string() const
  {
    return as<std::string>();
  }

  URBI_INLINE UVar::operator const UBinary&() const
  {
    return val();
  }

  URBI_INLINE UVar::operator UBinary*() const
  {
    return new UBinary(static_cast<const UBinary&>(val()));
  }

  URBI_INLINE UVar::operator UImage() const
  {
    return val();
  }

  URBI_INLINE UVar::operator USound() const
  {
    return val();
  }

  URBI_INLINE UVar::operator UList() const
  {
    return as<UList>();
  }

  URBI_INLINE UVar::operator UDictionary() const
  {
    return as<UDictionary>();
  }

  URBI_INLINE ufloat UVar::in() const
  {
    detail::Request request(URBI_VARIABLE_IN, context(), slot_);
    return read(request).reply().raw<ufloat>();
  }

  URBI_INLINE ufloat UVar::out() const
  {
    detail::Request request(URBI_VARIABLE_OUT, context(), slot_);
    return read(request).reply().raw<ufloat>();
  }

  URBI_INLINE utime_t UVar::timestamp() const
  {
    check();
    return detail::Request(URBI_VARIABLE_TIME, context(), slot_).send();
  }

  // ---------------------------------------------------------------- what becomes of it

  URBI_INLINE void UVar::setOwned()
  {
    check();
    detail::Request(URBI_VARIABLE_OWN, context(), slot_).send();
    owned = true;
  }

  URBI_INLINE void UVar::syncValue()
  {
    UValue read_now;
    detail::Request request(URBI_VARIABLE_SYNC, context(), slot_);
    read(request).reply().value(read_now);
    std::lock_guard<std::mutex> guard(lock_);
    kept() = std::move(read_now);
  }

  URBI_INLINE void UVar::keepSynchronized()
  {
    check();
    detail::Request(URBI_VARIABLE_KEEP, context(), slot_).send();
  }

  URBI_INLINE void UVar::unnotify()
  {
    check();
    detail::Request(URBI_VARIABLE_UNNOTIFY, context(), slot_).send();
  }

  URBI_INLINE bool UVar::setBypass(bool enable)
  {
    check();
    detail::Request request(URBI_VARIABLE_BYPASS, context(), slot_);
    request.out.raw(static_cast<int64_t>(enable));
    return request.send() != 0;
  }

  URBI_INLINE void UVar::useRTP(bool enable)
  {
    check();
    rtp_ = enable ? RTP_YES : RTP_NO;
    detail::Request request(URBI_VARIABLE_RTP, context(), slot_);
    request.out.raw(static_cast<int64_t>(enable));
    request.send();
  }

  URBI_INLINE UValue UVar::getProp(UProperty property) const
  {
    detail::Request request(URBI_VARIABLE_GET_PROPERTY, context(), slot_);
    request.out.raw(static_cast<int64_t>(property));
    UValue value;
    read(request).reply().value(value);
    return value;
  }

  URBI_INLINE void UVar::setProp(UProperty property, const UValue& value)
  {
    check();
    detail::Request request(URBI_VARIABLE_SET_PROPERTY, context(), slot_);
    request.out.raw(static_cast<int64_t>(property));
    request.out.value(value);
    request.send();
  }

  URBI_INLINE void UVar::setProp(UProperty property, ufloat value)
  {
    setProp(property, UValue(value));
  }

  URBI_INLINE void UVar::setProp(UProperty property, const char* value)
  {
    setProp(property, UValue(value));
  }

  URBI_INLINE void UVar::setProp(UProperty property, const std::string& value)
  {
    setProp(property, UValue(value));
  }

  URBI_INLINE std::ostream& operator<<(std::ostream& out, const UVar& variable)
  {
    return out << variable.val();
  }
}

#endif
