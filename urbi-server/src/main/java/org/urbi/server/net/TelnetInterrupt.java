package org.urbi.server.net;

/** The event for the interrupt or break key of a telnet client. */
enum TelnetInterrupt {
  INSTANCE
}
