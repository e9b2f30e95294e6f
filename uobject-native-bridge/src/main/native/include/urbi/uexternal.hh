/// Numbers of the messages that a server of 2.7 and remote components exchange.
#ifndef URBI_UEXTERNAL_HH
#define URBI_UEXTERNAL_HH

#include <string>

namespace urbi
{
  enum USystemExternalMessage
  {
    UEM_EVALFUNCTION, ///< calls a function
    UEM_ASSIGNVALUE,  ///< a variable has a new value
    UEM_EMITEVENT,
    UEM_ENDEVENT,
    UEM_NEW,    ///< makes an object
    UEM_DELETE, ///< ends an object
    UEM_INIT,
    UEM_TIMER,
    UEM_NORTP,  ///< no datagrams on this connection
    UEM_SETRTP, ///< datagrams for a variable
    UEM_REPLY,  ///< the result of a function
    UEM_EVAL,   ///< code to be executed
    UEM_SETLOCAL,
  };

  /// The tag of these messages.
  static const std::string externalModuleTag = "__ExternalMessage__";
}

#endif
