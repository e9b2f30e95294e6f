/// Tags of messages that clients exchange with a server.
#ifndef URBI_UTAG_HH
#define URBI_UTAG_HH

/// What the tags begin with that are nobody else's.
#define TAG_PRIVATE_PREFIX "__gostai_private__"

namespace urbi
{
  static const char* const connectionTimeoutTag = "client_error";
  static const char* const internalPongTag = TAG_PRIVATE_PREFIX "pong";
}

#endif
