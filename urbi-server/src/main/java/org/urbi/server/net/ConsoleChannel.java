package org.urbi.server.net;

import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.socket.nio.NioSocketChannel;
import io.netty.handler.ssl.SslHandler;
import java.nio.channels.SocketChannel;
import org.jspecify.annotations.Nullable;

/** The channel of a client; other threads may also write to its socket or read from it. */
final class ConsoleChannel extends NioSocketChannel {
  private boolean left;

  ConsoleChannel(Channel listener, SocketChannel socket) {
    super(listener, socket);
  }

  /** The channel of a client, unless something stands between its bytes and its socket. */
  static @Nullable ConsoleChannel bare(ChannelHandlerContext context) {
    return context.channel() instanceof ConsoleChannel own
            && context.pipeline().get(SslHandler.class) == null
        ? own
        : null;
  }

  /** The socket, which does not block. */
  SocketChannel socketChannel() {
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
