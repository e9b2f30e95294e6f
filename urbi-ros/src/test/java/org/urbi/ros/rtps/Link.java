package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.UnaryOperator;

/** What is between a participant and the network: loses datagrams, or all of them. */
final class Link implements UnaryOperator<DatagramSink> {
  private final Random random;
  private final int losesOneOf;
  private final AtomicLong lost = new AtomicLong();
  private volatile boolean cut;

  /** Loses one datagram of so many; none for 0. */
  Link(int losesOneOf, long seed) {
    this.losesOneOf = losesOneOf;
    random = new Random(seed);
  }

  /** From now on nothing comes through, or all does again. */
  void cut(boolean now) {
    cut = now;
  }

  @Override
  public DatagramSink apply(DatagramSink network) {
    return (datagram, to) -> {
      if (isLost()) lost.incrementAndGet();
      else network.send(datagram, to);
    };
  }

  /** How many it has lost. */
  long lost() {
    return lost.get();
  }

  private boolean isLost() {
    return cut || losesOneOf > 0 && random.nextInt(losesOneOf) == 0;
  }

  /** Sends a datagram as it is, from a socket of its own. */
  static void send(ByteBuffer datagram, InetSocketAddress to) throws java.io.IOException {
    try (var socket =
        java.nio.channels.DatagramChannel.open(java.net.StandardProtocolFamily.INET)) {
      socket.send(datagram, to);
    }
  }
}
