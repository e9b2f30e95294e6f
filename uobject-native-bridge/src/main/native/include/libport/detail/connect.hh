/// How all clients connect.
#ifndef LIBPORT_DETAIL_CONNECT_HH
#define LIBPORT_DETAIL_CONNECT_HH

#include <cerrno>
#include <cstring>
#include <netdb.h>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <system_error>
#include <unistd.h>

namespace libport
{
  namespace detail
  {
    /// Whether a host is the file of a Unix domain socket.
    inline bool is_file(const std::string& host)
    {
      return host.find('/') != std::string::npos;
    }

    /// A socket that is connected to an address; -1, and what is wrong, if it cannot be.
    inline int connected_to(int family, int type, int protocol, const sockaddr* address,
                            socklen_t length, std::error_code& error)
    {
      int made = ::socket(family, type, protocol);
      if (made != -1 && ::connect(made, address, length) == 0)
        return made;
      error = std::error_code(errno, std::generic_category());
      if (made != -1)
        ::close(made);
      return -1;
    }

    inline int connected_to_file(const std::string& file, std::error_code& error)
    {
      sockaddr_un address = sockaddr_un();
      address.sun_family = AF_UNIX;
      if (file.size() >= sizeof address.sun_path)
      {
        error = std::make_error_code(std::errc::filename_too_long);
        return -1;
      }
      std::memcpy(address.sun_path, file.c_str(), file.size());
      return connected_to(AF_UNIX, SOCK_STREAM, 0, reinterpret_cast<const sockaddr*>(&address),
                          sizeof address, error);
    }

    /// A connected socket; -1, and what is wrong, if there is none.
    ///
    /// \param host  a name or an address; one with a `/` is the file of a Unix domain socket, which
    ///              has no port
    /// \param type  SOCK_STREAM or SOCK_DGRAM
    inline int connected_socket(const std::string& host, const std::string& port, int type,
                                std::error_code& error)
    {
      if (type == SOCK_STREAM && is_file(host))
        return connected_to_file(host, error);
      error = std::make_error_code(std::errc::host_unreachable);
      addrinfo hints = addrinfo();
      hints.ai_socktype = type;
      addrinfo* all = nullptr;
      if (::getaddrinfo(host.c_str(), port.c_str(), &hints, &all) != 0)
        return -1;
      int made = -1;
      for (addrinfo* each = all; each && made == -1; each = each->ai_next)
        made = connected_to(each->ai_family, each->ai_socktype, each->ai_protocol, each->ai_addr,
                            each->ai_addrlen, error);
      ::freeaddrinfo(all);
      return made;
    }
  }
}

#endif
