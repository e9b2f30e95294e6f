/// Calls and connections that do not wait.
#ifndef LIBPORT_ASIO_HH
#define LIBPORT_ASIO_HH

#include <libport/async-call.hh>
#include <libport/bind.hh>
#include <libport/socket.hh>

#endif
