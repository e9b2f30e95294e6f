/// What whoever lives in a context can do.
#ifndef URBI_UCONTEXT_HH
#define URBI_UCONTEXT_HH

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <sstream>
#include <string>
#include <utility>

#include <libport/compiler.hh>
#include <libport/utime.hh>

#include <urbi/detail/host.hh>
#include <urbi/ucontext-impl.hh>
#include <urbi/uvalue.hh>

namespace urbi
{
  namespace detail
  {
    /// Sends what is written to it, when it is destroyed or flushed.
    class SendBuffer : public std::stringbuf
    {
    public:
      ~SendBuffer() override;

      int64_t context = 0;

    protected:
      int sync() override;
    };

    /// A stream of which every statement is sent when it has been written.
    class SendStream : private SendBuffer, public std::ostream
    {
    public:
      explicit SendStream(int64_t in);

      SendStream(SendStream&& other);
    };

    std::string formatted(const char* format, va_list arguments);

    /// The code in the double pair of parentheses of URBI((...)).
    std::string unarmored(const char* armored);
  }

  /// A value of anything that can be one.
  class UAutoValue : public UValue
  {
  public:
    UAutoValue() = default;

    UAutoValue(const UValue& value)
      : UValue(value)
    {}

    template <typename T>
    UAutoValue(const T& value)
    {
      *this, value;
    }
  };

  /// What objects, hubs, variables and events have in common.
  class UContext
  {
  public:
    /// The C++ object of that name, or null.
    UObject* getUObject(const std::string& name) const;

    /// The hub of that class, or null.
    UObjectHub* getUObjectHub(const std::string& className) const;

    /// Has urbiscript code executed, as if a client had sent it. Does not wait.
    void send(const std::string& code) const
    {
      detail::send_text(context(), code);
    }

    void send(const char* code) const;

    void send(const void* code, size_t size) const;

    /// Calls `object.method(arguments)` in urbiscript. Does not wait, the result is dropped.
    template <typename... Arguments>
    void call(const std::string& object, const std::string& method,
              const Arguments&... arguments) const
    {
      detail::Request request(URBI_CALL, context());
      request.out.text(object);
      request.out.text(method);
      (write(request.out, arguments), ...);
      request.send();
    }

    UObjectMode getRunningMode() const
    {
      return detail::running_mode(context());
    }

    bool isPluginMode() const
    {
      return getRunningMode() == MODE_PLUGIN;
    }

    bool isRemoteMode() const
    {
      return getRunningMode() == MODE_REMOTE;
    }

    /// Limits the number of threads that run threaded functions; 0 for any number.
    void setThreadLimit(size_t threads) const;

    /// Sends the code of URBI((...)); of URBI(()) what is written to the result.
    detail::SendStream uobject_unarmorAndSend(const char* armored) const;

    /// Lets everything else go on for a moment.
    void yield() const
    {
      urbi_module_yield(context(), 0);
    }

    /// Waits so many microseconds, while everything else goes on.
    void yield_for(libport::utime_t microseconds) const
    {
      urbi_module_yield(context(), microseconds);
    }

    /// Waits until it is that time, see libport::utime.
    void yield_until(libport::utime_t deadline) const
    {
      urbi_module_yield(context(), deadline - libport::utime());
    }

    /// Waits until something else has been done.
    void yield_until_things_changed() const
    {
      urbi_module_yield(context(), 0);
    }

    /// Marks this call as one that changes nothing. Nobody is faster by it here, it is only remembered.
    void side_effect_free_set(bool none)
    {
      detail::thread_state().sideEffectFree = none;
    }

    bool side_effect_free_get() const
    {
      return detail::thread_state().sideEffectFree;
    }

    /// The version of the kernel, as components know it.
    std::pair<int, int> kernelVersion() const
    {
      return std::pair<int, int>(detail::KERNEL_MAJOR, detail::KERNEL_MINOR);
    }

    /// Its context; null as long as there is none.
    impl::UContextImpl* ctx_;

  protected:
    UContext(impl::UContextImpl* context = nullptr)
      : ctx_(context ? context : getCurrentContext())
    {}

    int64_t context() const
    {
      return ctx_ ? ctx_->number() : detail::current_context();
    }

    template <typename T>
    static void write(detail::Writer& out, const T& argument)
    {
      UValue made;
      made = argument;
      out.value(made);
    }
  };

  // The same, for code that is in no object.

  UObject* getUObject(const std::string& name);
  UObjectHub* getUObjectHub(const std::string& className);

  void send(const std::string& code);

  void send(const void* code, size_t size);

  detail::SendStream uobject_unarmorAndSend(const char* armored);

  inline UObjectMode getRunningMode()
  {
    return detail::running_mode(detail::current_context());
  }

  inline bool isPluginMode()
  {
    return getRunningMode() == MODE_PLUGIN;
  }

  inline bool isRemoteMode()
  {
    return getRunningMode() == MODE_REMOTE;
  }

  /// Shows a text to people, on the server.
  ATTRIBUTE_PRINTF(1, 2)
  void echo(const char* format, ...);

  void setThreadLimit(size_t threads);

  /// The name of this computer, with `_` for what no name of a variable may have.
  std::string getFilteredHostname();
}

#ifdef URBI_HAS_CODE
#include <urbi/detail/code/ucontext.hh>
#endif

#endif
