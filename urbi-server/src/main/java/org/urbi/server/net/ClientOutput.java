package org.urbi.server.net;

import io.netty.buffer.Unpooled;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.socket.DuplexChannel;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;

/**
 * What waits to be sent to one client. The kernel adds and goes on, the network thread takes all
 * that has come together and sends it in one piece. A client that does not read what it asked for
 * is let go once the limit has been passed, since the kernel waits for nobody.
 */
final class ClientOutput {
  /** How long a client that was said goodbye may take to read the rest and to hang up. */
  private static final int FAREWELL_SECONDS = 5;

  private final Channel channel;
  private final long limit;
  private final Runnable overflow;
  private final StringBuilder waiting = new StringBuilder();
  private long unsent;
  private boolean scheduled;
  private boolean closed;

  /**
   * @param limit how many bytes may wait before the next one is too much
   * @param overflow called once, in the kernel's thread, when there is too much
   */
  ClientOutput(Channel channel, long limit, Runnable overflow) {
    this.channel = channel;
    this.limit = limit;
    this.overflow = overflow;
  }

  /** Adds bytes, one for each character; any thread, never waits. */
  void add(String bytes) {
    boolean tooMuch;
    synchronized (this) {
      if (closed) {
        return;
      }
      tooMuch = unsent > limit;
      if (tooMuch) {
        closed = true;
        waiting.setLength(0);
      } else {
        waiting.append(bytes);
        unsent += bytes.length();
        if (scheduled) {
          return;
        }
        scheduled = true;
      }
    }
    if (tooMuch) {
      overflow.run();
      channel.close();
    } else {
      channel.eventLoop().execute(this::flush);
    }
  }

  /** Sends what is left, then says goodbye; any thread. Nothing can be added any more. */
  void finish() {
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
    }
    channel.eventLoop().execute(this::farewell);
  }

  private ChannelFuture flush() {
    byte[] bytes;
    synchronized (this) {
      scheduled = false;
      bytes = waiting.toString().getBytes(StandardCharsets.ISO_8859_1);
      waiting.setLength(0);
    }
    ChannelFuture sent = channel.writeAndFlush(Unpooled.wrappedBuffer(bytes));
    return sent.addListener(done -> {
      synchronized (this) {
        unsent -= bytes.length;
      }
    });
  }

  /**
   * Ends the stream before closing, and reads on until the client has hung up: closing a socket
   * that has unread input would destroy output which is still on its way.
   */
  private void farewell() {
    channel.config().setAutoRead(true);
    channel.eventLoop().schedule((Runnable) channel::close, FAREWELL_SECONDS, TimeUnit.SECONDS);
    flush()
        .addListener(
            (ChannelFutureListener)
                done -> {
                  if (channel instanceof DuplexChannel duplex && !duplex.isInputShutdown()) {
                    duplex.shutdownOutput();
                  } else {
                    channel.close();
                  }
                });
  }
}
