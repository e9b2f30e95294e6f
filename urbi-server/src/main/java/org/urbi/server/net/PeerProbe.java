package org.urbi.server.net;

import io.netty.channel.Channel;
import io.netty.channel.ChannelOption;
import io.netty.channel.socket.nio.NioChannelOption;
import jdk.net.ExtendedSocketOptions;

/** Has the system ask whether the other end of a quiet connection is still there. */
final class PeerProbe {
  /** Seconds without traffic before the first question, and between two of them. */
  private static final int SECONDS = 5;

  /** How many questions may go without an answer. */
  private static final int ATTEMPTS = 3;

  private PeerProbe() {}

  /** Asks from now on; a connection whose peer has gone is then closed by the system. */
  static void start(Channel channel) {
    channel.config().setOption(ChannelOption.SO_KEEPALIVE, true);
    channel.config().setOption(NioChannelOption.of(ExtendedSocketOptions.TCP_KEEPIDLE), SECONDS);
    channel
        .config()
        .setOption(NioChannelOption.of(ExtendedSocketOptions.TCP_KEEPINTERVAL), SECONDS);
    channel.config().setOption(NioChannelOption.of(ExtendedSocketOptions.TCP_KEEPCOUNT), ATTEMPTS);
  }
}
