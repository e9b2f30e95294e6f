/// What clients of a server have in common: sending, messages, callbacks.
#ifndef URBI_UABSTRACTCLIENT_HH
#define URBI_UABSTRACTCLIENT_HH

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <list>
#include <mutex>
#include <ostream>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

#include <libport/lockable.hh>

#include <urbi/detail/message-splitter.hh>
#include <urbi/ucontext.hh>
#include <urbi/umessage.hh>

namespace urbi
{
  /// What becomes of a callback that has been called.
  enum UCallbackAction
  {
    URBI_CONTINUE = 0, ///< It is called again.
    URBI_REMOVE,       ///< It is not.
  };

  enum
  {
    URBI_MAX_TAG_LENGTH = 64
  };

  typedef unsigned int UCallbackID;
  enum
  {
    UINVALIDCALLBACKID = 0
  };
  typedef UCallbackAction (*UCallback)(const UMessage&);
  typedef UCallbackAction (*UCustomCallback)(void* data, const UMessage&);

  /// A callback as an object: a client deletes it.
  class UCallbackWrapper
  {
  public:
    virtual ~UCallbackWrapper() = default;
    virtual UCallbackAction operator()(const UMessage& message) = 0;
  };

  /// A stream with a lock for those who write several things in a row.
  class LockableOstream : public std::ostream
  {
  public:
    explicit LockableOstream(std::streambuf* buffer)
      : std::ostream(buffer)
    {}

    mutable libport::Lockable sendBufferLock;
  };

  /// A client. What is written to it as a stream is sent when it is flushed.
  class UAbstractClient : private std::stringbuf, public LockableOstream
  {
  public:
    enum
    {
      URBI_BUFLEN = 128000
    };
    enum
    {
      URBI_PORT = 54000
    };
    typedef int error_type;
    typedef std::function<UCallbackAction(const UMessage&)> callback_type;

    static const char* default_host()
    {
      return "127.0.0.1";
    }

    UAbstractClient(const std::string& host, unsigned port)
      : LockableOstream(static_cast<std::stringbuf*>(this))
      , host_(host)
      , port_(port)
      , rc(0)
      , timestamp_(0)
      , counter_(0)
    {}

    ~UAbstractClient() override = default;

    /// 0 if it is connected.
    error_type error() const
    {
      return rc;
    }

    bool init() const
    {
      return rc == 0;
    }

    const std::string& getServerName() const
    {
      return host_;
    }

    unsigned getServerPort() const
    {
      return port_;
    }

    /// This client as a stream.
    std::ostream& stream_get()
    {
      return *this;
    }

    /// The time stamp of the last message, in milliseconds.
    int getCurrentTimestamp() const
    {
      return timestamp_;
    }

    /// The version of the server, for which it is asked when somebody wants to know it.
    const std::string& kernelVersion() const
    {
      waitForKernelVersion();
      return kernelVersion_;
    }

    int kernelMajor() const
    {
      return std::atoi(kernelVersion().c_str());
    }

    int kernelMinor() const
    {
      size_t point = kernelVersion().find('.');
      return point == std::string::npos ? 0 : std::atoi(kernelVersion_.c_str() + point + 1);
    }

    /// The name of this connection's lobby, for which the server is asked when somebody wants to know it.
    const std::string& connectionID() const
    {
      waitForConnectionID();
      return connectionID_;
    }

    virtual void waitForKernelVersion() const = 0;
    virtual void waitForConnectionID() const = 0;
    ATTRIBUTE_PRINTF(2, 3)
    virtual void printf(const char* format, ...) = 0;
    virtual unsigned getCurrentTime() const = 0;
    virtual void setKeepAliveCheck(unsigned pingInterval, unsigned pongTimeout) = 0;

    // ---------------------------------------------------------------- sending: 0 if it went well

    error_type send(const std::string& code)
    {
      std::lock_guard<std::mutex> guard(sending_);
      return rc = effectiveSend(code.data(), code.size());
    }

#if defined __GNUC__
    __attribute__((format(printf, 2, 3)))
#endif
    error_type
    send(const char* format, ...)
    {
      va_list arguments;
      va_start(arguments, format);
      std::string code = detail::formatted(format, arguments);
      va_end(arguments);
      return send(code);
    }

    error_type send(const UValue& value)
    {
      return send(detail::literal_of(value));
    }

    error_type send(std::istream& in)
    {
      return send(std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()));
    }

    /// Sends a binary literal.
    error_type sendBinary(const void* data, size_t length, const std::string& header)
    {
      std::string code = "BIN " + detail::number_text(static_cast<ufloat>(length));
      code += (header.empty() ? "" : " " + header) + ";";
      code.append(static_cast<const char*>(data), length);
      return send(code);
    }

    error_type sendBin(const void* data, size_t length)
    {
      return sendBinary(data, length, "");
    }

    ATTRIBUTE_PRINTF(4, 5)
    error_type sendBin(const void* data, size_t length, const char* header, ...)
    {
      va_list arguments;
      va_start(arguments, header);
      std::string words = detail::formatted(header, arguments);
      va_end(arguments);
      return sendBinary(data, length, words);
    }

    /// What is packed from now on is sent in one piece by endPack.
    error_type startPack()
    {
      pack_.clear();
      return 0;
    }

    ATTRIBUTE_PRINTF(2, 3)
    error_type pack(const char* format, ...)
    {
      va_list arguments;
      va_start(arguments, format);
      error_type result = vpack(format, arguments);
      va_end(arguments);
      return result;
    }

    error_type vpack(const char* format, va_list arguments)
    {
      pack_ += detail::formatted(format, arguments);
      return 0;
    }

    error_type endPack()
    {
      std::string all;
      all.swap(pack_);
      return send(all);
    }

    /// Has a device play a sound. \param tag on which `*** stop` is told when it has been sent
    error_type sendSound(const char* device, const USound& sound, const char* tag = nullptr)
    {
      std::string code = std::string(device) + ".val = ";
      UBinary data(sound, false);
      code += "BIN " + detail::number_text(static_cast<ufloat>(data.common.size)) + " "
              + data.getMessage() + ";";
      code.append(static_cast<const char*>(data.common.data), data.common.size);
      code += "|;";
      if (tag)
        code += "lobby.send(\"*** stop\", \"" + std::string(tag) + "\")|;";
      return send(code + "\n");
    }

    /// Writes a file on the side of the server.
    error_type putFile(const char* local, const char* remote = nullptr)
    {
      std::ifstream in(local, std::ios::binary);
      if (!in)
        return -1;
      std::string all((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
      return putFile(all.data(), all.size(), remote ? remote : local);
    }

    error_type putFile(const void* data, size_t length, const char* remote)
    {
      UValue name{std::string(remote)};
      UValue text{std::string(static_cast<const char*>(data), length)};
      return send("File.save(" + detail::literal_of(name) + ", " + detail::literal_of(text) + ")|;\n");
    }

    /// Sends the contents of a file.
    error_type sendFile(const std::string& file)
    {
      std::ifstream in(file, std::ios::binary);
      return in ? send(in) : -1;
    }

    /// Sends code whose answers go to a callback.
    UCallbackID sendCommand(const callback_type& callback, const std::string& code)
    {
      std::string tag = fresh();
      UCallbackID id = setCallback(callback, tag.c_str());
      send("Channel.new(\"" + tag + "\") << " + code);
      return id;
    }

    ATTRIBUTE_PRINTF(3, 4)
    UCallbackID sendCommand(UCallback callback, const char* format, ...)
    {
      va_list arguments;
      va_start(arguments, format);
      std::string code = detail::formatted(format, arguments);
      va_end(arguments);
      return sendCommand(callback_type(callback), code);
    }

    ATTRIBUTE_PRINTF(4, 5)
    UCallbackID sendCommand(UCustomCallback callback, void* data, const char* format, ...)
    {
      va_list arguments;
      va_start(arguments, format);
      std::string code = detail::formatted(format, arguments);
      va_end(arguments);
      return sendCommand([=](const UMessage& message) { return callback(data, message); }, code);
    }

    // ---------------------------------------------------------------- callbacks

    /// Has a function called with each message of a tag.
    UCallbackID setCallback(const callback_type& callback, const char* tag)
    {
      return add(BY_TAG, tag, callback);
    }

    UCallbackID setCallback(UCallbackWrapper& callback, const char* tag)
    {
      std::shared_ptr<UCallbackWrapper> own(&callback);
      return setCallback([own](const UMessage& message) { return (*own)(message); }, tag);
    }

    UCallbackID setCallback(UCustomCallback callback, void* data, const char* tag)
    {
      return setCallback([=](const UMessage& message) { return callback(data, message); }, tag);
    }

    /// Has the function of an object called, with what is given before the message; the tag comes last.
    template <typename C, typename... A, typename... G>
    UCallbackID setCallback(C& object, UCallbackAction (C::*function)(A...), const G&... given)
    {
      static_assert(sizeof...(A) == sizeof...(G), "a value for each argument, and the tag");
      return setBound(object, function, std::tuple<std::decay_t<const G&>...>(given...),
                      std::make_index_sequence<sizeof...(G) - 1>());
    }

    /// With each message that is an error.
    UCallbackID setErrorCallback(const callback_type& callback)
    {
      return add(ERRORS, "", callback);
    }

    /// With each message.
    UCallbackID setWildcardCallback(const callback_type& callback)
    {
      return add(ALL, "", callback);
    }

    /// When the connection is lost.
    UCallbackID setClientErrorCallback(const callback_type& callback)
    {
      return add(CLIENT_ERRORS, "", callback);
    }

    /// 1 if there was such a callback.
    int deleteCallback(UCallbackID id)
    {
      std::lock_guard<std::mutex> guard(lock_);
      size_t before = callbacks_.size();
      callbacks_.remove_if([id](const Entry& each) { return each.id == id; });
      return before != callbacks_.size();
    }

    /// Calls the callbacks that want a message.
    virtual void notifyCallbacks(const UMessage& message)
    {
      timestamp_ = message.timestamp;
      std::list<Entry> wanted;
      {
        std::lock_guard<std::mutex> guard(lock_);
        for (const Entry& each : callbacks_)
          if (each.kind == ALL || (each.kind == ERRORS && message.type == MESSAGE_ERROR)
              || (each.kind == CLIENT_ERRORS && message.tag == clientErrorTag())
              || (each.kind == BY_TAG && each.tag == message.tag))
            wanted.push_back(each);
      }
      for (const Entry& each : wanted)
        if (each.function(message) == URBI_REMOVE)
          deleteCallback(each.id);
    }

    /// A tag that nobody has used yet.
    std::string fresh()
    {
      std::lock_guard<std::mutex> guard(lock_);
      return "URBI_" + detail::number_text(++counter_);
    }

    void makeUniqueTag(char* out)
    {
      std::string tag = fresh();
      std::memcpy(out, tag.c_str(), tag.size() + 1);
    }

    static constexpr const char* CLIENTERROR_TAG = "client_error";

    static const char* clientErrorTag()
    {
      return CLIENTERROR_TAG;
    }

  protected:
    virtual error_type effectiveSend(const void* buffer, size_t size) = 0;

    int sync() override
    {
      std::string code = str();
      str("");
      return code.empty() ? 0 : send(code);
    }

    std::string host_;
    unsigned port_;
    error_type rc;
    mutable std::string kernelVersion_;
    mutable std::string connectionID_;
    std::atomic<int> timestamp_;

  private:
    enum Kind
    {
      BY_TAG,
      ERRORS,
      ALL,
      CLIENT_ERRORS,
    };

    struct Entry
    {
      Kind kind;
      std::string tag;
      callback_type function;
      UCallbackID id;
    };

    template <typename C, typename F, typename Given, size_t... I>
    UCallbackID setBound(C& object, F function, const Given& given, std::index_sequence<I...>)
    {
      return setCallback(callback_type([&object, function, given](const UMessage& message) {
                           return (object.*function)(std::get<I>(given)..., message);
                         }),
                         std::string(std::get<sizeof...(I)>(given)).c_str());
    }

    UCallbackID add(Kind kind, const char* tag, const callback_type& callback)
    {
      std::lock_guard<std::mutex> guard(lock_);
      UCallbackID id = ++counter_;
      callbacks_.push_back(Entry{kind, tag, callback, id});
      return id;
    }

    std::mutex lock_;
    std::mutex sending_;
    std::list<Entry> callbacks_;
    unsigned counter_;
    std::string pack_;
  };

  /// A callback that is the function of an object, with what is given before the message.
  template <typename C, typename... A, typename... G>
  UAbstractClient::callback_type callback(C& object, UCallbackAction (C::*function)(A...),
                                          const G&... given)
  {
    static_assert(sizeof...(A) == sizeof...(G) + 1, "a value for each argument");
    return [&object, function, given...](const UMessage& message) {
      return (object.*function)(given..., message);
    };
  }

  inline UAbstractClient::callback_type callback(UCallback function)
  {
    return function;
  }

  inline UAbstractClient::callback_type callback(UCustomCallback function, void* data)
  {
    return [function, data](const UMessage& message) { return function(data, message); };
  }

  static const char semicolon = ';';
  static const char pipe = '|';
  static const char parallel = '&';
  static const char comma = ',';
}

#endif
