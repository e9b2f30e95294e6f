package org.urbi.server.net;

import io.netty.channel.Channel;
import io.netty.channel.socket.nio.NioSocketChannel;
import java.nio.channels.SocketChannel;

/** A client's channel, whose socket may be written to, or read from, by other threads, too. */
final class ConsoleChannel extends NioSocketChannel {
  private boolean left;

  ConsoleChannel(Channel listener, SocketChannel socket) {
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
