package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;

/** Where datagrams go. */
@FunctionalInterface
interface DatagramSink {
  /** Sends {@code datagram}, or loses it: as with all of UDP, nobody knows. */
  void send(ByteBuffer datagram, InetSocketAddress to);
}
