/// Connections of the network.
#ifndef LIBPORT_SOCKET_HH
#define LIBPORT_SOCKET_HH

#include <atomic>
#include <cerrno>
#include <functional>
#include <mutex>
#include <string>
#include <sys/socket.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <libport/compiler.hh>
#include <libport/detail/connect.hh>
#include <libport/lockable.hh>
#include <libport/utime.hh>

namespace libport
{
  /// A connection. A thread of its own receives, and calls onRead.
  class Socket : public Lockable
  {
  public:
    Socket()
      : socket_(-1)
      , sent_(0)
      , received_(0)
    {}

    virtual ~Socket()
    {
      destroy();
    }

    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;

    /// Connects; a host with a `/` is the file of a Unix domain socket. \return what is wrong, or nothing
    std::error_code connect(const std::string& host, const std::string& port, bool udp = false)
    {
      close();
      std::error_code error;
      int made = detail::connected_socket(host, port, udp ? SOCK_DGRAM : SOCK_STREAM, error);
      if (made == -1)
        return error;
      join();
      socket_ = made;
      onConnect();
      receiver_ = std::thread([this, made] { run(made); });
      return std::error_code();
    }

    std::error_code connect(const std::string& host, unsigned port, bool udp = false)
    {
      return connect(host, std::to_string(port), udp);
    }

    bool isConnected() const
    {
      return socket_ != -1;
    }

    /// Sends all of it, or loses the connection.
    void write(const void* data, size_t length)
    {
      BlockLock lock(*this);
      const char* at = static_cast<const char*>(data);
      while (length && socket_ != -1)
      {
        ssize_t sent = ::send(socket_, at, length, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
          continue;
        if (sent < 0)
        {
          ::shutdown(socket_, SHUT_RDWR);
          return;
        }
        at += sent;
        length -= static_cast<size_t>(sent);
        sent_ += static_cast<unsigned long>(sent);
      }
    }

    void write(const std::string& data)
    {
      write(data.data(), data.size());
    }

    void send(const void* data, size_t length)
    {
      write(data, length);
    }

    void send(const std::string& data)
    {
      write(data);
    }

    void close()
    {
      int present = socket_;
      if (present != -1)
        ::shutdown(present, SHUT_RDWR);
    }

    unsigned long bytesSent() const
    {
      return sent_;
    }

    unsigned long bytesReceived() const
    {
      return received_;
    }

  protected:
    virtual void onConnect()
    {}

    virtual void onError(std::error_code)
    {}

    /// What has come and was not taken yet. \return how many bytes of it are taken
    virtual size_t onRead(const void*, size_t length)
    {
      return length;
    }

    /// Ends the connection and its thread: a subclass whose functions are called says it in its
    /// destructor.
    void destroy()
    {
      close();
      join();
    }

    void wasDestroyed()
    {
      destroy();
    }

    bool checkDestructionPermission() const
    {
      return true;
    }

  private:
    void join()
    {
      if (!receiver_.joinable())
        return;
      if (receiver_.get_id() == std::this_thread::get_id())
        receiver_.detach();
      else
        receiver_.join();
    }

    void run(int own)
    {
      std::string pending;
      char buffer[16384];
      std::error_code error;
      for (;;)
      {
        ssize_t length = ::recv(own, buffer, sizeof buffer, 0);
        if (length < 0 && errno == EINTR)
          continue;
        if (length < 0)
          error = std::error_code(errno, std::generic_category());
        if (length <= 0)
          break;
        received_ += static_cast<unsigned long>(length);
        pending.append(buffer, static_cast<size_t>(length));
        size_t taken;
        while (!pending.empty() && (taken = onRead(pending.data(), pending.size())) != 0)
          pending.erase(0, taken);
      }
      {
        BlockLock lock(*this);
        socket_ = -1;
        ::close(own);
      }
      onError(error);
    }

    std::atomic<int> socket_;
    std::atomic<unsigned long> sent_;
    std::atomic<unsigned long> received_;
    std::thread receiver_;
  };
}

#endif
