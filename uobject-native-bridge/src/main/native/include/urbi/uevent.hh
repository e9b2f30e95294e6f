/// Events of urbiscript.
#ifndef URBI_UEVENT_HH
#define URBI_UEVENT_HH

#include <string>

#include <urbi/ucontext.hh>
#include <urbi/uvalue.hh>

namespace urbi
{
  /// An event, which C++ code emits.
  class UEvent : public UContext
  {
  public:
    /// An event to be bound by UBindEvent or init.
    UEvent()
      : event_(-1)
    {}

    /// The event `object.slot`.
    explicit UEvent(const std::string& name, impl::UContextImpl* context = nullptr);

    UEvent(const std::string& object, const std::string& slot,
           impl::UContextImpl* context = nullptr);

    UEvent(UObject& object, const std::string& slot, impl::UContextImpl* context = nullptr);

    /// The same event as another.
    UEvent(const UEvent& other);

    UEvent& operator=(const UEvent& other);

    ~UEvent();

    /// Binds it. \throw std::runtime_error if there is no such object
    void init(const std::string& object, const std::string& slot,
              impl::UContextImpl* context = nullptr);

    /// Emits the event. Does not wait for those who handle it.
    ///
    /// \param payload  of any types to which values can be converted
    template <typename... Payload>
    void emit(const Payload&... payload) const
    {
      if (event_ == -1)
        throw std::runtime_error("invalid use of unbound UEvent");
      detail::Request request(URBI_EVENT_EMIT, context(), event_);
      (write(request.out, payload), ...);
      request.send();
    }

    const std::string& get_name() const
    {
      return name_;
    }

  private:
    void bind(const std::string& name);

    void close() noexcept;

    int64_t event_;
    std::string name_;
  };
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/uevent.hh>
#endif

#endif
