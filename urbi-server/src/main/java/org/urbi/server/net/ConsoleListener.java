package org.urbi.server.net;

import io.netty.channel.socket.nio.NioServerSocketChannel;
import java.io.IOException;
import java.nio.channels.SocketChannel;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.urbi.server.Trace;

/**
 * The listening channel. When the system has no socket for another client, clients wait in the
 * system's queue, and the channel tries again soon.
 */
final class ConsoleListener extends NioServerSocketChannel {
  private static final long PAUSE_MILLISECONDS = 100;

  private final Trace trace;
  private boolean told;

  ConsoleListener(Trace trace) {
    this.trace = trace;
  }

  @Override
  protected int doReadMessages(List<Object> accepted) throws IOException {
    SocketChannel socket;
    try {
      socket = javaChannel().accept();
      told &= socket == null;
    } catch (IOException e) {
      if (!isOpen()) {
        throw e;
      }
      pause(e);
      return 0;
    }
    if (socket == null) {
      return 0;
    }
    accepted.add(new ConsoleChannel(this, socket));
    return 1;
  }

  private void pause(IOException cause) {
    if (!told) {
      told = true;
      trace.log("cannot let a client in, trying again until it can be: " + cause.getMessage());
    }
    config().setAutoRead(false);
    eventLoop()
        .schedule(() -> config().setAutoRead(true), PAUSE_MILLISECONDS, TimeUnit.MILLISECONDS);
  }
}
