/// What comes by standard input, and contents of files.
#ifndef LIBPORT_READ_STDIN_HH
#define LIBPORT_READ_STDIN_HH

#include <string>
#include <unistd.h>

#include <libport/file-system.hh>

namespace libport
{
  /// What has come by now: waits for some of it. Nothing at the end.
  inline std::string read_stdin()
  {
    char buffer[4096];
    ssize_t length = ::read(STDIN_FILENO, buffer, sizeof buffer);
    return length > 0 ? std::string(buffer, static_cast<size_t>(length)) : std::string();
  }
}

#endif
