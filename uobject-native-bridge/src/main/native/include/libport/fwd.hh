/// Declarations of the classes of this layer.
#ifndef LIBPORT_FWD_HH
#define LIBPORT_FWD_HH

#include <memory>
#include <string>
#include <vector>

#include <libport/boost-names.hh>

namespace libport
{
  class AbstractOptionParser;
  class Finally;
  class Lockable;
  class OptionFlag;
  class OptionParser;
  class OptionValue;
  class OptionValues;
  class PackageInfo;
  class Semaphore;
  class Socket;
  class ThreadPool;

  typedef std::vector<std::string> cli_args_type;
}

#endif
