/// What urbi/uevent.hh declares: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/uevent.hh>

#ifndef URBI_DETAIL_CODE_UEVENT_HH
#define URBI_DETAIL_CODE_UEVENT_HH

namespace urbi
{
  URBI_INLINE UEvent::UEvent(const std::string& name, impl::UContextImpl* context)
    : UEvent()
  {
    if (context)
      ctx_ = context;
    bind(name);
  }

  URBI_INLINE UEvent::UEvent(const std::string& object, const std::string& slot,
         impl::UContextImpl* context)
    : UEvent()
  {
    init(object, slot, context);
  }

  URBI_INLINE UEvent::UEvent(const UEvent& other)
    : UEvent()
  {
    ctx_ = other.ctx_;
    if (other.event_ != -1)
      bind(other.name_);
  }

  URBI_INLINE UEvent& UEvent::operator=(const UEvent& other)
  {
    if (this != &other && other.event_ != -1)
    {
      ctx_ = other.ctx_;
      bind(other.name_);
    }
    return *this;
  }

  URBI_INLINE UEvent::~UEvent()
  {
    close();
  }

  URBI_INLINE void UEvent::init(const std::string& object, const std::string& slot,
            impl::UContextImpl* context)
  {
    if (context)
      ctx_ = context;
    bind(object + "." + slot);
  }

  URBI_INLINE void UEvent::bind(const std::string& name)
  {
    detail::Request request(URBI_EVENT, context());
    request.out.text(name);
    int64_t event = request.send();
    close();
    event_ = event;
    name_ = name;
  }

  URBI_INLINE void UEvent::close() noexcept
  {
    if (event_ == -1)
      return;
    try
    {
      detail::Request(URBI_EVENT_CLOSE, context(), event_).send();
    }
    catch (const std::exception&)
    {
      // The host has gone, and the event with it.
    }
    event_ = -1;
  }
}

#endif
