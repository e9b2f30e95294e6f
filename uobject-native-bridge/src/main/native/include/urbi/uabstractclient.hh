/// What clients of a server have in common: sending, messages, callbacks.
#ifndef URBI_UABSTRACTCLIENT_HH
#define URBI_UABSTRACTCLIENT_HH

#include <cstdarg>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <list>
#include <mutex>
#include <ostream>
#include <sstream>
#include <string>

#include <urbi/umessage.hh>

namespace urbi
{
  /// What becomes of a callback that has been called.
  enum UCallbackAction
  {
    URBI_CONTINUE = 0, ///< It is called again.
    URBI_REMOVE,       ///< It is not.
  };

  typedef unsigned int UCallbackID;
  enum
  {
    UINVALIDCALLBACKID = 0
  };
  typedef UCallbackAction (*UCallback)(const UMessage&);
  typedef UCallbackAction (*UCustomCallback)(void* data, const UMessage&);

  namespace detail
  {
    /// Takes the bytes of a server apart into messages.
    class MessageSplitter
    {
    public:
      /// Takes bytes in; calls `take(timestamp, tag, text)` for each message that is complete.
      template <typename Taker>
      void feed(const char* bytes, size_t length, const Taker& take)
      {
        pending_.append(bytes, length);
        for (;;)
        {
          size_t end = message_end();
          if (end == std::string::npos)
            return;
          std::string line = pending_.substr(0, end);
          pending_.erase(0, end + 1);
          while (!line.empty() && line.back() == '\r')
            line.pop_back();
          if (!line.empty())
            split(line, take);
        }
      }

    private:
      /// The line end after a message, past the data of its binaries.
      size_t message_end() const
      {
        size_t at = pending_.find("] ");
        if (at != std::string::npos
            && (pending_.compare(at + 2, 3, "***") == 0 || pending_.compare(at + 2, 3, "!!!") == 0))
          // Text for people, whatever is in it.
          return pending_.find('\n', at);
        at = 0;
        bool quoted = false;
        for (; at < pending_.size(); ++at)
        {
          char c = pending_[at];
          if (c == '\n')
            return at;
          if (quoted && c == '\\')
            ++at;
          else if (c == '"')
            quoted = !quoted;
          else if (!quoted && c == 'B' && pending_.compare(at, 4, "BIN ") == 0
                   && (at == 0 || !std::isalnum(static_cast<unsigned char>(pending_[at - 1]))))
          {
            size_t size = 0, digit = at + 4;
            for (; digit < pending_.size() && std::isdigit(static_cast<unsigned char>(pending_[digit]));
                 ++digit)
              size = size * 10 + static_cast<size_t>(pending_[digit] - '0');
            size_t header = pending_.find_first_of(";\n", digit);
            if (header == std::string::npos)
              return header;
            if (pending_.size() - header - 1 < size)
              return std::string::npos;
            at = header + size;
          }
        }
        return std::string::npos;
      }

      template <typename Taker>
      static void split(const std::string& line, const Taker& take)
      {
        size_t close = line.find(']');
        if (line[0] != '[' || close == std::string::npos)
          return;
        size_t colon = line.find(':');
        std::string tag;
        if (colon < close)
          tag = line.substr(colon + 1, close - colon - 1);
        int time = std::atoi(line.c_str() + 1);
        size_t text = close + 1;
        if (text < line.size() && line[text] == ' ')
          ++text;
        take(time, tag, line.substr(text));
      }

      std::string pending_;
    };
  }

  /// A client. What is written to it as a stream is sent when it is flushed.
  class UAbstractClient : private std::stringbuf, public std::ostream
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
      : std::ostream(static_cast<std::stringbuf*>(this))
      , host_(host)
      , port_(port)
      , rc(0)
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
      std::string code = formatted(format, arguments);
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

    // ---------------------------------------------------------------- callbacks

    /// Has a function called with each message of a tag.
    UCallbackID setCallback(const callback_type& callback, const char* tag)
    {
      return add(BY_TAG, tag, callback);
    }

    UCallbackID setCallback(UCustomCallback callback, void* data, const char* tag)
    {
      return setCallback([=](const UMessage& message) { return callback(data, message); }, tag);
    }

    template <typename C>
    UCallbackID setCallback(C& object, UCallbackAction (C::*function)(const UMessage&),
                            const char* tag)
    {
      return setCallback([&object, function](const UMessage& m) { return (object.*function)(m); },
                         tag);
    }

    template <typename C, typename P1>
    UCallbackID setCallback(C& object, UCallbackAction (C::*function)(P1, const UMessage&), P1 p1,
                            const char* tag)
    {
      return setCallback(
        [&object, function, p1](const UMessage& m) { return (object.*function)(p1, m); }, tag);
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

    static const char* clientErrorTag()
    {
      return "client_error";
    }

  protected:
    virtual error_type effectiveSend(const void* buffer, size_t size) = 0;

    static std::string formatted(const char* format, va_list arguments)
    {
      va_list again;
      va_copy(again, arguments);
      int length = std::vsnprintf(nullptr, 0, format, again);
      va_end(again);
      std::string text(length < 0 ? 0 : static_cast<size_t>(length), '\0');
      std::vsnprintf(&text[0], text.size() + 1, format, arguments);
      return text;
    }

    int sync() override
    {
      std::string code = str();
      str("");
      return code.empty() ? 0 : send(code);
    }

    std::string host_;
    unsigned port_;
    error_type rc;

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
  };

  /// A callback that is the function of an object.
  template <typename C>
  UAbstractClient::callback_type callback(C& object,
                                          UCallbackAction (C::*function)(const UMessage&))
  {
    return [&object, function](const UMessage& message) { return (object.*function)(message); };
  }

  inline UAbstractClient::callback_type callback(UCallback function)
  {
    return function;
  }

  static const char semicolon = ';';
  static const char pipe = '|';
  static const char parallel = '&';
  static const char comma = ',';
}

#endif
