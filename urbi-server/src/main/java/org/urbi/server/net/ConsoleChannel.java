package org.urbi.server.net;

import io.netty.channel.Channel;
import io.netty.channel.socket.nio.NioServerSocketChannel;
import io.netty.channel.socket.nio.NioSocketChannel;
import java.io.IOException;
import java.nio.channels.SocketChannel;
import java.util.List;

/** A client's channel, whose socket may be written to, or read from, by other threads, too. */
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

  private boolean left;

  private ConsoleChannel(Channel listener, SocketChannel socket) {
    super(listener, socket);
  }

  /** The socket, which does not block. */
  SocketChannel bare() {
    return javaChannel();
  }

  /** Leaves the reading to somebody else; on the network thread. */
  void leaveReading() {
    left = true;
    clearReadPending();
  }

  /** Reads again; on the network thread. */
  void resumeReading() {
    left = false;
    if (config().isAutoRead()) {
      read();
    }
  }

  @Override
  protected void doBeginRead() throws Exception {
    if (!left) {
      super.doBeginRead();
    }
  }
}
