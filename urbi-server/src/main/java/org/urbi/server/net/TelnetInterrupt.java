package org.urbi.server.net;

/** The event that a telnet client's interrupt or break key becomes. */
enum TelnetInterrupt {
  INSTANCE
}
