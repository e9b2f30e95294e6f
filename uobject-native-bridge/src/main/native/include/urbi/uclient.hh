/// Clients of a server.
#ifndef URBI_UCLIENT_HH
#define URBI_UCLIENT_HH

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <thread>

#include <cerrno>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

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
    /// Connects. \see error
    explicit UClient(const std::string& host = default_host(), unsigned port = URBI_PORT,
                     size_t = URBI_BUFLEN)
      : UClient(host, port, true)
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
      if (socket_ != -1)
        ::shutdown(socket_, SHUT_RDWR);
      return 0;
    }

#if defined __GNUC__
    __attribute__((format(printf, 2, 3)))
#endif
    void
    printf(const char* format, ...)
    {
      va_list arguments;
      va_start(arguments, format);
      std::string text = formatted(format, arguments);
      va_end(arguments);
      std::fwrite(text.data(), 1, text.size(), stderr);
    }

    /// Milliseconds since the client was made.
    unsigned getCurrentTime() const
    {
      return static_cast<unsigned>(std::chrono::duration_cast<std::chrono::milliseconds>(
                                     std::chrono::steady_clock::now() - started_)
                                     .count());
    }

  protected:
    UClient(const std::string& host, unsigned port, bool receiving)
      : UAbstractClient(host, port)
      , socket_(-1)
      , started_(std::chrono::steady_clock::now())
    {
      connect();
      if (receiving)
        receive();
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
      while (size)
      {
        ssize_t sent = socket_ == -1 ? -1 : ::send(socket_, at, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR && socket_ != -1)
          continue;
        if (sent < 0)
          return -1;
        at += sent;
        size -= static_cast<size_t>(sent);
      }
      return 0;
    }

  private:
    void connect()
    {
      addrinfo hints = addrinfo();
      hints.ai_socktype = SOCK_STREAM;
      addrinfo* all = nullptr;
      std::string port = detail::number_text(port_);
      rc = -1;
      if (::getaddrinfo(host_.c_str(), port.c_str(), &hints, &all) != 0)
        return;
      for (addrinfo* each = all; each && rc; each = each->ai_next)
      {
        socket_ = ::socket(each->ai_family, each->ai_socktype, each->ai_protocol);
        if (socket_ != -1 && ::connect(socket_, each->ai_addr, each->ai_addrlen) == 0)
          rc = 0;
        else if (socket_ != -1)
        {
          ::close(socket_);
          socket_ = -1;
        }
      }
      ::freeaddrinfo(all);
    }

    void run()
    {
      detail::MessageSplitter splitter;
      char buffer[16384];
      for (;;)
      {
        ssize_t length = ::recv(socket_, buffer, sizeof buffer, 0);
        if (length < 0 && errno == EINTR)
          continue;
        if (length <= 0)
          break;
        splitter.feed(buffer, static_cast<size_t>(length),
                      [this](int time, const std::string& tag, const std::string& text) {
                        received(UMessage(*this, time, tag, text));
                      });
      }
      received(UMessage(*this, 0, clientErrorTag(), "!!! End of file"));
    }

    int socket_;
    std::thread receiver_;
    std::chrono::steady_clock::time_point started_;
  };

  namespace detail
  {
    URBI_LOCAL inline UClient*& default_client()
    {
      static UClient* client = nullptr;
      return client;
    }

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

  /// The client that URBI((...)) uses: the first that `connect` has made.
  inline UClient* getDefaultClient()
  {
    return detail::default_client();
  }

  inline UClient& get_default_client()
  {
    return *getDefaultClient();
  }

  inline void setDefaultClient(UClient* client)
  {
    detail::default_client() = client;
  }

  /// Connects to a server; to be ended by `disconnect`.
  inline UClient& connect(const std::string& host)
  {
    UClient* client = new UClient(host);
    if (!getDefaultClient())
      setDefaultClient(client);
    return *client;
  }

  inline void disconnect(UClient& client)
  {
    if (getDefaultClient() == &client)
      setDefaultClient(nullptr);
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

#endif
