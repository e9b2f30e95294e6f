/// Timers as objects.
#ifndef URBI_UTIMER_CALLBACK_HH
#define URBI_UTIMER_CALLBACK_HH

#include <functional>
#include <string>

#include <urbi/uobject.hh>
#include <urbi/utable.hh>

namespace urbi
{
  /// A function that is called every so many milliseconds.
  class UTimerCallback
  {
  public:
    UTimerCallback(const std::string& object, ufloat milliseconds, impl::UContextImpl* context)
      : period(milliseconds)
      , lastTimeCalled(-9999999)
      , objname(object)
      , ctx_(context ? context : getCurrentContext())
    {}

    virtual ~UTimerCallback() = default;
    UTimerCallback(const UTimerCallback&) = delete;
    UTimerCallback& operator=(const UTimerCallback&) = delete;

    virtual void call() = 0;

    /// Starts it. It has to live as long as its object, or until `UObject::removeTimer`.
    void registerCallback()
    {
      UObject* owner = ctx_->getUObject(objname);
      if (!owner)
        throw std::runtime_error("no object " + objname);
      handle_ = owner->USetTimer(period, std::function<void()>([this] { call(); }));
    }

    TimerHandle handle_get() const
    {
      return handle_;
    }

    ufloat period;
    ufloat lastTimeCalled;
    std::string objname;

  private:
    impl::UContextImpl* ctx_;
    TimerHandle handle_;
  };

  /// One that calls a function.
  template <class T>
  class UTimerCallbackobj : public UTimerCallback
  {
  public:
    UTimerCallbackobj(const std::string& object, ufloat period, T*,
                      const std::function<void()>& function, impl::UContextImpl* context)
      : UTimerCallback(object, period, context)
      , function_(function)
    {
      registerCallback();
    }

    void call() override
    {
      function_();
    }

  private:
    std::function<void()> function_;
  };
}

#endif
