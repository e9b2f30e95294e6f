/// Clients of a server.
#ifndef URBI_UCLIENT_HH
#define URBI_UCLIENT_HH

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <thread>

#include <cerrno>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <libport/cstring>
#include <libport/debug.hh>
#include <libport/detail/connect.hh>
#include <libport/detail/tls.hh>
#include <libport/foreach.hh>
#include <libport/format.hh>
#include <libport/lockable.hh>
#include <libport/semaphore.hh>
#include <libport/sysexits.hh>
#include <libport/utime.hh>

#include <urbi/uabstractclient.hh>
#include <urbi/ucontext.hh>

/// Sends code by the default client: URBI((...)), or URBI(()) << ... .
#ifndef URBI
#define URBI(A) ::urbi::unarmorAndSend(#A)
#endif

namespace urbi
{
  /// A connection to a server. A thread of its own receives, and calls the callbacks.
  class UClient : public UAbstractClient
  {
  public:
#define URBI_CLIENT_OPTION_(Class, Type, Name)                                                    \
  Class& Name(Type value)                                                                         \
  {                                                                                               \
    Name##_ = value;                                                                              \
    return *this;                                                                                 \
  }                                                                                               \
  Type Name() const                                                                               \
  {                                                                                               \
    return Name##_;                                                                               \
  }

    /// How a client is made.
    class options
    {
    public:
      explicit options(bool = false)
        : start_(true)
        , asynchronous_(false)
      {}

      /// Whether it connects at once, or when `start` is called.
      URBI_CLIENT_OPTION_(options, bool, start)
      /// Of no effect.
      URBI_CLIENT_OPTION_(options, bool, asynchronous)

    private:
      bool start_;
      bool asynchronous_;
    };

    /// Connects; a host with a `/` is the file of a Unix domain socket. URBI_TLS in the environment
    /// asks for TLS, except for such a file. \see error, errorMessage
    explicit UClient(const std::string& host = default_host(), unsigned port = URBI_PORT,
                     size_t = URBI_BUFLEN, const options& how = options())
      : UClient(host, port, how.start(), true)
    {}

    ~UClient() override
    {
      flush();
      finish();
    }

    UClient(const UClient&) = delete;
    UClient& operator=(const UClient&) = delete;

    /// Closes the connection.
    int closeUClient()
    {
      if (tls_)
        tls_->endOutput();
      if (socket_ != -1)
        ::shutdown(socket_, SHUT_RDWR);
      return 0;
    }

    /// Connects, if it has not yet. \return 0 if it is connected
    error_type start()
    {
      if (socket_ == -1)
      {
        connect();
        if (receiving_)
          receive();
      }
      return rc;
    }

    /// Asks for the version of the server, and waits for it.
    void waitForKernelVersion() const override
    {
      learn(kernelVersion_, "System.version", "1");
    }

    /// Asks for the name of this connection's lobby, and waits for it.
    void waitForConnectionID() const override
    {
      learn(connectionID_, "connectionTag.name", "");
    }

    /// Sending always waits until the system has taken the bytes.
    void setSynchronousSend(bool) {}

    /// Has the connection end if the other side does not answer any more.
    ///
    /// \param pingInterval  milliseconds after which the system asks whether it is there
    /// \param pongTimeout   milliseconds in which it has to be
    void setKeepAliveCheck(unsigned pingInterval, unsigned pongTimeout) override
    {
      int on = pingInterval != 0;
      int idle = pingInterval < 1000 ? 1 : static_cast<int>(pingInterval / 1000);
      int timeout = static_cast<int>(pingInterval + pongTimeout);
      ::setsockopt(socket_, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
      ::setsockopt(socket_, IPPROTO_TCP, TCP_KEEPIDLE, &idle, sizeof idle);
      ::setsockopt(socket_, IPPROTO_TCP, TCP_USER_TIMEOUT, &timeout, sizeof timeout);
    }

    /// Why it could not connect; empty if it could.
    const std::string& errorMessage() const
    {
      return problem_;
    }

    unsigned long bytesSent() const
    {
      return sent_;
    }

    unsigned long bytesReceived() const
    {
      return came_;
    }

    ATTRIBUTE_PRINTF(2, 3)
    void printf(const char* format, ...) override
    {
      va_list arguments;
      va_start(arguments, format);
      std::string text = detail::formatted(format, arguments);
      va_end(arguments);
      std::fwrite(text.data(), 1, text.size(), stderr);
    }

    /// Milliseconds since the client was made.
    unsigned getCurrentTime() const override
    {
      return static_cast<unsigned>(std::chrono::duration_cast<std::chrono::milliseconds>(
                                     std::chrono::steady_clock::now() - started_)
                                     .count());
    }

  protected:
    /// \param receiving  whether it starts to receive as soon as it is connected
    UClient(const std::string& host, unsigned port, bool connecting, bool receiving)
      : UAbstractClient(host, port)
      , socket_(-1)
      , receiving_(receiving)
      , sent_(0)
      , came_(0)
      , started_(std::chrono::steady_clock::now())
    {
      if (connecting)
        start();
    }

    /// Asks for a string, and waits for it, unless it is known.
    /// \param otherwise  what it is if the server does not understand the question
    void learn(std::string& known, const std::string& question, const std::string& otherwise) const
    {
      if (!known.empty() || rc)
        return;
      // A client is asked for it where it is const.
      UClient& self = const_cast<UClient&>(*this);
      // Shared with the callback, which may be called when nobody waits any more. Not a future: all
      // that include this would read its header for this one use.
      struct Answer
      {
        std::string text;
        libport::Semaphore come;
      };
      auto answer = std::make_shared<Answer>();
      self.sendCommand(
        [answer, otherwise](const UMessage& message) {
          bool text = message.value && message.value->type == DATA_STRING;
          answer->text = text ? *message.value->stringValue : otherwise;
          answer->come++;
          return URBI_REMOVE;
        },
        question + ";\n");
      const libport::utime_t seconds = 1000000;
      if (answer->come.uget(5 * seconds))
        known = answer->text;
    }

    /// Starts to receive.
    void receive()
    {
      if (socket_ != -1)
        receiver_ = std::thread([this] { run(); });
    }

    /// A message has come, on the thread that receives.
    virtual void received(const UMessage& message)
    {
      notifyCallbacks(message);
    }

    /// Ends the thread that receives: to be called before what it uses has gone.
    void finish()
    {
      closeUClient();
      if (receiver_.joinable())
      {
        if (receiver_.get_id() == std::this_thread::get_id())
          receiver_.detach();
        else
          receiver_.join();
      }
      if (socket_ != -1)
        ::close(socket_);
      socket_ = -1;
    }

    error_type effectiveSend(const void* buffer, size_t size) override
    {
      const char* at = static_cast<const char*>(buffer);
      if (tls_)
      {
        if (!tls_->send(at, size))
          return -1;
        sent_ += static_cast<unsigned long>(size);
        return 0;
      }
      while (size)
      {
        ssize_t sent = socket_ == -1 ? -1 : ::send(socket_, at, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR && socket_ != -1)
          continue;
        if (sent < 0)
          return -1;
        at += sent;
        size -= static_cast<size_t>(sent);
        sent_ += static_cast<unsigned long>(sent);
      }
      return 0;
    }

  private:
    void connect()
    {
      std::error_code error;
      socket_ =
        libport::detail::connected_socket(host_, detail::number_text(port_), SOCK_STREAM, error);
      rc = socket_ == -1 ? -1 : 0;
      if (rc)
        problem_ = error.message();
      else if (!libport::detail::is_file(host_) && libport::detail::TlsSettings::wanted())
        secure();
      if (!rc)
        showToken();
    }

    void secure()
    {
      try
      {
        tls_.reset(new libport::detail::Tls(socket_, host_));
      }
      catch (const std::runtime_error& e)
      {
        problem_ = e.what();
        std::cerr << "urbi::UClient: cannot connect to " << host_ << ":" << port_ << ": " << problem_
                  << std::endl;
        ::close(socket_);
        socket_ = -1;
        rc = -1;
      }
    }

    ssize_t take(char* buffer, size_t size)
    {
      return tls_ ? tls_->receive(buffer, size) : ::recv(socket_, buffer, size, 0);
    }

    /// Sends the token in the environment: a comment, which servers without tokens ignore.
    void showToken()
    {
      const char* token = std::getenv("URBI_TOKEN");
      if (token && *token)
      {
        std::string line(token);
        line = "//token " + line.substr(0, line.find_first_of("\r\n")) + "\n";
        effectiveSend(line.data(), line.size());
      }
    }

    void run()
    {
      detail::MessageSplitter splitter;
      char buffer[16384];
      for (;;)
      {
        ssize_t length = take(buffer, sizeof buffer);
        if (length < 0 && !tls_ && errno == EINTR)
          continue;
        if (length <= 0)
          break;
        came_ += static_cast<unsigned long>(length);
        splitter.feed(buffer, static_cast<size_t>(length),
                      [this](int time, const std::string& tag, const std::string& text) {
                        received(UMessage(*this, time, tag, text));
                      });
      }
      received(UMessage(*this, 0, clientErrorTag(), "!!! End of file"));
    }

    int socket_;
    std::unique_ptr<libport::detail::Tls> tls_;
    std::string problem_;
    bool receiving_;
    std::atomic<unsigned long> sent_;
    std::atomic<unsigned long> came_;
    std::thread receiver_;
    std::chrono::steady_clock::time_point started_;
  };

  namespace detail
  {
    /// The clients that code uses which names none.
    struct DefaultClients
    {
      std::mutex lock;
      UClient* chosen = nullptr;
      UClient* own = nullptr; ///< that of a remote process, which it has been given
    };

    URBI_LOCAL inline DefaultClients& default_clients()
    {
      static DefaultClients all;
      return all;
    }

    /// Connects to the server that runs the objects of this process; null if there is none.
    UClient* connect_to_own_server();

    /// Sends what is written to it by a client.
    class ClientStream : private std::stringbuf, public std::ostream
    {
    public:
      explicit ClientStream(UClient* client)
        : std::ostream(static_cast<std::stringbuf*>(this))
        , client_(client)
      {}

      ClientStream(ClientStream&& other)
        : ClientStream(other.client_)
      {}

      ~ClientStream() override
      {
        sync();
      }

    protected:
      int sync() override
      {
        std::string code = str();
        str("");
        return client_ && !code.empty() ? client_->send(code) : 0;
      }

    private:
      UClient* client_;
    };
  }

  /// The client that URBI((...)) uses: the first that `connect` has made. In a remote process it is one
  /// that is connected to the server of its objects, if there has been none before; else null.
  inline UClient* getDefaultClient()
  {
    detail::DefaultClients& all = detail::default_clients();
    std::lock_guard<std::mutex> guard(all.lock);
    if (!all.chosen)
    {
      if (!all.own)
        all.own = detail::connect_to_own_server();
      all.chosen = all.own;
    }
    return all.chosen;
  }

  inline UClient& get_default_client()
  {
    return *getDefaultClient();
  }

  inline void setDefaultClient(UClient* client)
  {
    detail::DefaultClients& all = detail::default_clients();
    std::lock_guard<std::mutex> guard(all.lock);
    all.chosen = client;
  }

  /// The name of the lobby of a client's connection.
  inline std::string getClientConnectionID(const UAbstractClient* client)
  {
    return client ? client->connectionID() : std::string();
  }

  /// Connects to a server; to be ended by `disconnect`.
  inline UClient& connect(const std::string& host)
  {
    UClient* client = new UClient(host);
    detail::DefaultClients& all = detail::default_clients();
    std::lock_guard<std::mutex> guard(all.lock);
    if (!all.chosen)
      all.chosen = client;
    return *client;
  }

  inline void disconnect(UClient& client)
  {
    {
      detail::DefaultClients& all = detail::default_clients();
      std::lock_guard<std::mutex> guard(all.lock);
      if (all.chosen == &client)
        all.chosen = nullptr;
      if (all.own == &client)
        all.own = nullptr;
    }
    delete &client;
  }

  inline detail::ClientStream unarmorAndSend(const char* armored,
                                             UClient* client = getDefaultClient())
  {
    std::string code = detail::unarmored(armored);
    if (client && !code.empty())
      client->send(code);
    return detail::ClientStream(client);
  }

  /// The default client as a stream.
  inline std::ostream& default_stream()
  {
    return get_default_client();
  }

  /// Waits for ever: all the rest is done by callbacks.
  inline void execute()
  {
    for (;;)
      std::this_thread::sleep_for(std::chrono::hours(1));
  }

  [[noreturn]] inline void exit(int code)
  {
    std::exit(code);
  }
}

// The default client of a remote process is one of these.
#include <urbi/usyncclient.hh>

#endif
