/// Clients that wait for answers.
#ifndef URBI_USYNCCLIENT_HH
#define URBI_USYNCCLIENT_HH

#include <algorithm>

#include <urbi/uclient.hh>
#include <urbi/uconversion.hh>

namespace urbi
{
  /// How images travel.
  enum UTransmitFormat
  {
    URBI_TRANSMIT_JPEG,
    URBI_TRANSMIT_YCbCr,
  };

  /// A client that can wait for the answer to a question, in callbacks too: a thread calls these,
  /// and what comes while one of them waits is called later.
  class USyncClient : public UClient
  {
  public:
    /// How a client is made.
    class options : public UClient::options
    {
    public:
      options()
        : startCallbackThread_(true)
      {}

      /// Whether a thread calls the callbacks: see processEvents.
      URBI_CLIENT_OPTION_(options, bool, startCallbackThread)

    private:
      bool startCallbackThread_;
    };

    /// How it is asked.
    struct send_options
    {
      /// How long to wait for the answer, in microseconds; 0 for ever.
      send_options& timeout(utime_t useconds)
      {
        timeout_ = useconds;
        return *this;
      }

      /// The tag of the answer; a fresh one if it is null.
      send_options& tag(const char* name, const char* = nullptr)
      {
        mtag_ = name;
        return *this;
      }

      utime_t timeout_ = 0;
      const char* mtag_ = nullptr;
      static const send_options default_options;
    };

    explicit USyncClient(const std::string& host = default_host(), unsigned port = URBI_PORT,
                         size_t buffer = URBI_BUFLEN, bool callbackThread = true)
      : USyncClient(host, port, buffer, options().startCallbackThread(callbackThread))
    {}

    /// Connects.
    USyncClient(const std::string& host, unsigned port, size_t, const options& how)
      : UClient(host, port, true, false)
      , lost_(false)
      , ended_(false)
      , kept_(false)
      , synchronous_(false)
    {
      receive();
      if (how.startCallbackThread())
        caller_ = std::thread([this] {
          while (!ended_)
            processEvents(100000);
        });
    }

    ~USyncClient() override
    {
      flush();
      stopCallbackThread();
      finish();
    }

    /// From now on only processEvents calls callbacks.
    void stopCallbackThread()
    {
      ended_ = true;
      arrived_.notify_all();
      if (caller_.joinable() && caller_.get_id() != std::this_thread::get_id())
        caller_.join();
    }

    /// Calls the callbacks for all messages that have come.
    ///
    /// \param useconds  how long to wait for the first one; -1 for not at all
    /// \return whether there was one
    bool processEvents(utime_t useconds = -1)
    {
      std::unique_lock<std::mutex> guard(queue_);
      if ((messages_.empty() || kept_) && useconds > 0)
        arrived_.wait_for(guard, std::chrono::microseconds(useconds));
      bool some = false;
      while (!messages_.empty() && !kept_)
      {
        UMessage message(messages_.front());
        messages_.pop_front();
        guard.unlock();
        notifyCallbacks(message);
        some = true;
        guard.lock();
      }
      return some;
    }

    /// Waits for the next message of a tag. \param useconds  how long; 0 for ever
    /// \return to be deleted; null if it has not come
    UMessage* waitForTag(const std::string& tag, utime_t useconds = 0)
    {
      expect(tag);
      takeKept(tag);
      return wait(tag, useconds);
    }

    /// From now on messages wait for waitForTag, which is called for the answer to what is sent next.
    void lockQueue()
    {
      std::lock_guard<std::mutex> guard(queue_);
      kept_ = true;
    }

    /// Whether the thread that receives calls the callbacks itself.
    void setSynchronous(bool enable)
    {
      synchronous_ = enable;
    }

    /// How it is asked from now on.
    void setDefaultOptions(const send_options& how)
    {
      default_options_ = how;
    }

    /// These options; those of setDefaultOptions in place of the default ones.
    const send_options& getOptions(const send_options& how = send_options::default_options) const
    {
      return &how == &send_options::default_options ? default_options_ : how;
    }

    /// The value of an expression, to be deleted; null after the time.
    UMessage* syncGet(const std::string& expression)
    {
      return syncGet(expression, default_options_.timeout_);
    }

    UMessage* syncGet(const std::string& expression, utime_t useconds)
    {
      return ask(expression, default_options_.mtag_, useconds);
    }

    /// The value of an expression, sent with that tag.
#if defined __GNUC__
    __attribute__((format(printf, 2, 5)))
#endif
    UMessage*
    syncGetTag(const char* format, const char* tag, const char* modifier, ...)
    {
      va_list arguments;
      va_start(arguments, modifier);
      std::string expression = detail::formatted(format, arguments);
      va_end(arguments);
      return ask(expression, tag, default_options_.timeout_);
    }

#if defined __GNUC__
    __attribute__((format(printf, 3, 6)))
#endif
    UMessage*
    syncGetTag(utime_t useconds, const char* format, const char* tag, const char* modifier, ...)
    {
      va_list arguments;
      va_start(arguments, modifier);
      std::string expression = detail::formatted(format, arguments);
      va_end(arguments);
      return ask(expression, tag, useconds);
    }

#if defined __GNUC__
    __attribute__((format(printf, 2, 3)))
#endif
    UMessage*
    syncGet(const char* format, ...)
    {
      va_list arguments;
      va_start(arguments, format);
      std::string expression = detail::formatted(format, arguments);
      va_end(arguments);
      return syncGet(expression);
    }

#if defined __GNUC__
    __attribute__((format(printf, 3, 4)))
#endif
    UMessage*
    syncGet(utime_t useconds, const char* format, ...)
    {
      va_list arguments;
      va_start(arguments, format);
      std::string expression = detail::formatted(format, arguments);
      va_end(arguments);
      return syncGet(expression, useconds);
    }

    // The following return 1 if they have got the value, and 0 otherwise.

    int syncGetValue(const char* name, UValue& value, utime_t useconds = 0)
    {
      return getValue(syncGet(std::string(name), useconds), value);
    }

    int syncGetDevice(const char* device, ufloat& value, utime_t useconds = 0)
    {
      return getValue(syncGet(std::string(device) + ".val", useconds), value);
    }

    int syncGetDevice(const char* device, const char* field, ufloat& value, utime_t useconds = 0)
    {
      return getValue(syncGet(std::string(device) + "." + field, useconds), value);
    }

    int syncGetNormalizedDevice(const char* device, ufloat& value, utime_t useconds = 0)
    {
      return getValue(syncGet(std::string(device) + ".valn", useconds), value);
    }

    int syncGetResult(const char* command, ufloat& value, utime_t useconds = 0)
    {
      return getValue(syncGet(std::string(command), useconds), value);
    }

    int syncGetValue(const char*, const char* name, UValue& value, utime_t useconds)
    {
      return syncGetValue(name, value, useconds);
    }

    /// Takes the image of a camera as it is. \param size  room in the buffer, and what is used of it
    int syncGetImage(const char* camera, void* buffer, size_t& size, size_t& width, size_t& height,
                     utime_t useconds = 0)
    {
      UBinary image;
      return image_of(camera, image, useconds) && stored(image.image, buffer, size, width, height);
    }

    /// Takes the image of a camera in a format.
    int syncGetImage(const char* camera, void* buffer, size_t& size, int format, int,
                     size_t& width, size_t& height, utime_t useconds = 0)
    {
      UBinary image;
      if (!image_of(camera, image, useconds))
        return 0;
      UImage wanted;
      wanted.imageFormat = static_cast<UImageFormat>(format);
      int got = convert(image.image, wanted) && stored(wanted, buffer, size, width, height);
      std::free(wanted.data);
      return got;
    }

    /// Takes what a microphone hears in so many milliseconds. Its data are to be freed by the caller.
    int syncGetSound(const char* device, int duration, USound& sound, utime_t useconds = 0)
    {
      UBinary heard;
      std::string name(device);
      if (!getValue(syncGet("{ sleep(" + std::to_string(duration) + "ms)| " + name + ".val }", useconds),
                    heard)
          || heard.type != BINARY_SOUND)
        return 0;
      return convert(heard.sound, sound);
    }

    /// Sends bytes, 0 if it went well.
    int syncSend(const void* data, size_t length)
    {
      return send(std::string(static_cast<const char*>(data), length));
    }

    using UClient::waitForKernelVersion;

    /// \param calling  whether a thread calls the callbacks, or this one has to
    void waitForKernelVersion(bool calling)
    {
      std::thread caller;
      std::atomic<bool> known(false);
      if (!calling)
        caller = std::thread([&] {
          while (!known)
            processEvents(1000);
        });
      waitForKernelVersion();
      known = true;
      if (caller.joinable())
        caller.join();
    }

    /// Whether this is the thread that calls the callbacks.
    bool isCallbackThread() const
    {
      return std::this_thread::get_id() == caller_.get_id();
    }

  protected:
    void received(const UMessage& message) override
    {
      std::unique_lock<std::mutex> guard(queue_);
      if (message.tag == clientErrorTag())
        lost_ = true;
      std::list<std::string>::iterator wanted
        = std::find(awaited_.begin(), awaited_.end(), message.tag);
      if (synchronous_ && !kept_ && wanted == awaited_.end())
      {
        guard.unlock();
        notifyCallbacks(message);
        return;
      }
      (wanted == awaited_.end() ? messages_ : answers_).push_back(message);
      arrived_.notify_all();
    }

  private:
    UMessage* ask(const std::string& expression, const char* wanted, utime_t useconds)
    {
      std::string tag = wanted && *wanted ? wanted : fresh();
      expect(tag);
      send("{ var urbiAnswer = Channel.new(\"" + tag + "\")| try { urbiAnswer << ("
           + stripped(expression)
           + ") } catch (var urbiError) { lobby.send(\"!!! \" + urbiError.asString().replace(\"\\n\", \" \"), \""
           + tag + "\") } },\n");
      return wait(tag, useconds);
    }

    static std::string stripped(const std::string& expression)
    {
      size_t end = expression.find_last_not_of(" \t\r\n;,");
      return expression.substr(0, end == std::string::npos ? 0 : end + 1);
    }

    int image_of(const char* camera, UBinary& image, utime_t useconds)
    {
      return getValue(syncGet(std::string(camera) + ".val", useconds), image)
             && image.type == BINARY_IMAGE;
    }

    static int stored(const UImageImpl& image, void* buffer, size_t& size, size_t& width,
                      size_t& height)
    {
      if (image.size > size)
        return 0;
      std::memcpy(buffer, image.data, image.size);
      size = image.size;
      width = image.width;
      height = image.height;
      return 1;
    }

    /// Messages of a tag are for somebody who waits, and not for callbacks.
    void expect(const std::string& tag)
    {
      std::lock_guard<std::mutex> guard(queue_);
      awaited_.push_back(tag);
    }

    /// The queue is no longer locked; the answer may be in it.
    void takeKept(const std::string& tag)
    {
      std::lock_guard<std::mutex> guard(queue_);
      if (!kept_)
        return;
      kept_ = false;
      std::list<UMessage>::iterator come = messages_.begin();
      while (come != messages_.end() && come->tag != tag)
        ++come;
      if (come != messages_.end())
        answers_.splice(answers_.end(), messages_, come);
      arrived_.notify_all();
    }

    UMessage* wait(const std::string& tag, utime_t useconds)
    {
      std::unique_lock<std::mutex> guard(queue_);
      std::list<UMessage>::iterator found;
      auto come = [&] {
        found = std::find_if(answers_.begin(), answers_.end(),
                             [&](const UMessage& each) { return each.tag == tag; });
        return found != answers_.end() || lost_;
      };
      if (useconds == 0)
        arrived_.wait(guard, come);
      else
        arrived_.wait_for(guard, std::chrono::microseconds(useconds), come);
      awaited_.erase(std::find(awaited_.begin(), awaited_.end(), tag));
      if (found == answers_.end())
        return nullptr;
      UMessage* answer = new UMessage(*found);
      answers_.erase(found);
      return answer;
    }

    std::mutex queue_;
    std::condition_variable arrived_;
    std::list<UMessage> messages_;
    std::list<UMessage> answers_;
    std::list<std::string> awaited_;
    bool lost_;
    std::thread caller_;
    std::atomic<bool> ended_;
    bool kept_;
    std::atomic<bool> synchronous_;
    send_options default_options_;
  };

  inline const USyncClient::send_options USyncClient::send_options::default_options;

  namespace detail
  {
    inline UClient* connect_to_own_server()
    {
      std::string host;
      unsigned port = 0;
      if (!server(current_context(), host, port))
        return nullptr;
      // Its threads have to end before the module is unloaded.
      module().closers.push_back([] {
        UClient* made = default_clients().own;
        if (made)
          disconnect(*made);
        return true;
      });
      return new USyncClient(host, port);
    }
  }
}

#endif
