package org.urbi.server.net;

import io.netty.channel.Channel;
import io.netty.channel.socket.nio.NioServerSocketChannel;
import io.netty.channel.socket.nio.NioSocketChannel;
import java.io.IOException;
import java.nio.channels.SocketChannel;
import java.util.List;

/** A client's channel, whose socket may be written to by other threads, too. */
final class ConsoleChannel extends NioSocketChannel {
  /** The channel that listens. */
  static final class Listener extends NioServerSocketChannel {
    @Override
    protected int doReadMessages(List<Object> accepted) throws IOException {
      SocketChannel socket = javaChannel().accept();
      if (socket == null) {
        return 0;
      }
      accepted.add(new ConsoleChannel(this, socket));
      return 1;
    }
  }

  private ConsoleChannel(Channel listener, SocketChannel socket) {
    super(listener, socket);
  }

  /** The socket, which does not block. */
  SocketChannel bare() {
    return javaChannel();
  }
}
