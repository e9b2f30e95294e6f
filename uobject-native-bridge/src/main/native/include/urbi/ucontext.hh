/// What whoever lives in a context can do.
#ifndef URBI_UCONTEXT_HH
#define URBI_UCONTEXT_HH

#include <chrono>
#include <cstdint>
#include <sstream>
#include <string>
#include <thread>

#include <urbi/detail/host.hh>
#include <urbi/uvalue.hh>

namespace urbi
{
  /// Where the objects of this module live.
  enum UObjectMode
  {
    MODE_PLUGIN = 1, ///< in the process of the kernel
    MODE_REMOTE = 2, ///< in another one
  };

  /// Microseconds.
  typedef long long utime_t;

  namespace detail
  {
    /// Sends what is written to it, when it is destroyed or flushed.
    class SendBuffer : public std::stringbuf
    {
    public:
      ~SendBuffer() override
      {
        sync();
      }

      int64_t context = 0;

    protected:
      int sync() override
      {
        std::string code = str();
        if (code.empty())
          return 0;
        str("");
        try
        {
          Request request(URBI_SEND, context ? context : current_context());
          request.out.text(code);
          request.send();
        }
        catch (const std::exception&)
        {
          return -1;
        }
        return 0;
      }
    };

    /// A stream of which every statement is sent when it has been written.
    class SendStream : private SendBuffer, public std::ostream
    {
    public:
      explicit SendStream(int64_t in)
        : std::ostream(static_cast<SendBuffer*>(this))
      {
        context = in;
      }

      SendStream(SendStream&& other)
        : SendStream(other.context)
      {}
    };

    inline void send_text(int64_t context, const std::string& code)
    {
      Request request(URBI_SEND, context);
      request.out.text(code);
      request.send();
    }

    /// The code in the double pair of parentheses of URBI((...)).
    inline std::string unarmored(const char* armored)
    {
      std::string code(armored);
      size_t begin = code.find_first_not_of(" \t\n");
      size_t end = code.find_last_not_of(" \t\n");
      if (begin == std::string::npos)
        return "";
      if (code[begin] == '(' && code[end] == ')')
        return code.substr(begin + 1, end - begin - 1);
      return code.substr(begin, end - begin + 1);
    }
  }

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

    void send(const char* code) const
    {
      send(std::string(code));
    }

    void send(const void* code, size_t size) const
    {
      send(std::string(static_cast<const char*>(code), size));
    }

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
      return static_cast<UObjectMode>(detail::Request(URBI_MODE, context()).send());
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
    void setThreadLimit(size_t threads) const
    {
      detail::Request request(URBI_THREAD_LIMIT, context());
      request.out.raw(static_cast<int64_t>(threads));
      request.send();
    }

    /// Sends the code of URBI((...)); of URBI(()) what is written to the result.
    detail::SendStream uobject_unarmorAndSend(const char* armored) const
    {
      std::string code = detail::unarmored(armored);
      if (!code.empty())
        send(code);
      return detail::SendStream(context());
    }

    /// Lets other threads run.
    void yield() const
    {
      std::this_thread::yield();
    }

    /// Waits so many microseconds.
    void yield_for(utime_t microseconds) const
    {
      std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
    }

  protected:
    UContext()
      : ctx_(detail::current_context())
    {}

    explicit UContext(int64_t context)
      : ctx_(context)
    {}

    int64_t context() const
    {
      return ctx_ ? ctx_ : detail::current_context();
    }

    template <typename T>
    static void write(detail::Writer& out, const T& argument)
    {
      UValue made;
      made = argument;
      out.value(made);
    }

    /// The number of its context; 0 as long as there is none.
    int64_t ctx_;
  };

  // The same, for code that is in no object.

  inline UObject* getUObject(const std::string& name);
  inline UObjectHub* getUObjectHub(const std::string& className);

  inline void send(const std::string& code)
  {
    detail::send_text(detail::current_context(), code);
  }

  inline void send(const void* code, size_t size)
  {
    send(std::string(static_cast<const char*>(code), size));
  }

  inline detail::SendStream uobject_unarmorAndSend(const char* armored)
  {
    std::string code = detail::unarmored(armored);
    if (!code.empty())
      send(code);
    return detail::SendStream(detail::current_context());
  }

  inline UObjectMode getRunningMode()
  {
    return static_cast<UObjectMode>(
      detail::Request(URBI_MODE, detail::current_context()).send());
  }

  inline bool isPluginMode()
  {
    return getRunningMode() == MODE_PLUGIN;
  }

  inline bool isRemoteMode()
  {
    return getRunningMode() == MODE_REMOTE;
  }

  inline void setThreadLimit(size_t threads)
  {
    detail::Request request(URBI_THREAD_LIMIT, detail::current_context());
    request.out.raw(static_cast<int64_t>(threads));
    request.send();
  }
}

#endif
