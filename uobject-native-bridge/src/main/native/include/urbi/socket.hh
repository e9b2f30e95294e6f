/// Objects that are connections of the network.
#ifndef URBI_SOCKET_HH
#define URBI_SOCKET_HH

#include <libport/socket.hh>

#include <urbi/uobject.hh>

namespace urbi
{
  /// A base class, beside UObject, of objects that are connections.
  class UObjectSocket : public libport::Socket
  {
  public:
    ~UObjectSocket() override
    {
      destroy();
    }
  };
}

#endif
