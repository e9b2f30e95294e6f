package org.urbi.server.net;

import io.netty.channel.Channel;
import io.netty.channel.socket.nio.NioSocketChannel;
import java.nio.channels.SocketChannel;

/** The channel of a client; other threads may also write to its socket or read from it. */
final class ConsoleChannel extends NioSocketChannel {
  private boolean left;

  ConsoleChannel(Channel listener, SocketChannel socket) {
    super(listener, socket);
  }

  /** The socket, which does not block. */
  SocketChannel bare() {
    return javaChannel();
  }

  /** Stops reading, because another thread does it. Called on the network thread. */
  void leaveReading() {
    left = true;
    clearReadPending();
  }

  /** Resumes reading. Called on the network thread. */
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
