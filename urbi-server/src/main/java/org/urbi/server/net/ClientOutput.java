package org.urbi.server.net;

import io.netty.buffer.Unpooled;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.socket.DuplexChannel;
import java.nio.charset.StandardCharsets;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;

/**
 * What waits to be sent to one client. The kernel adds and goes on, the network thread takes all
 * that has come together and sends it in one piece. A client that does not read what it asked for
 * is let go once the limit has been passed, since the kernel waits for nobody. There is no lock:
 * the kernel may be within a job when it adds, and a job that waits for a lock would let others
 * run.
 */
final class ClientOutput {
  /** How long a client that was said goodbye may take to read the rest and to hang up. */
  private static final int FAREWELL_SECONDS = 5;

  /** What no number of bytes makes positive again. */
  private static final long GONE = Long.MIN_VALUE / 2;

  private final Channel channel;
  private volatile long limit;
  private final TotalOutput together;
  private final Runnable overflow;
  private final Queue<String> waiting = new ConcurrentLinkedQueue<>();
  private final AtomicLong unsent = new AtomicLong();
  private final AtomicBoolean scheduled = new AtomicBoolean();
  private final AtomicBoolean closed = new AtomicBoolean();

  /**
   * @param limit how many bytes may wait before the next one is too much
   * @param together what waits for all clients
   * @param overflow called once, in the kernel's thread, when there is too much
   */
  ClientOutput(Channel channel, long limit, TotalOutput together, Runnable overflow) {
    this.channel = channel;
    this.limit = limit;
    this.together = together;
    together.come();
    this.overflow = overflow;
  }

  /** So many bytes may wait, if that is more than before. */
  void allow(long bytes) {
    limit = Math.max(limit, bytes);
  }

  /** Adds bytes, one for each character; any thread, never waits. */
  void add(String bytes) {
    if (closed.get()) {
      return;
    }
    if (unsent.get() > limit || together.isTooMuch(unsent.get())) {
      if (closed.compareAndSet(false, true)) {
        waiting.clear();
        overflow.run();
        channel.close();
      }
      return;
    }
    count(bytes.length());
    waiting.add(bytes);
    if (scheduled.compareAndSet(false, true)) {
      NetworkThread.execute(channel.eventLoop(), this::flush);
    }
  }

  /** Sends what is left, then says goodbye; any thread. Nothing can be added any more. */
  void finish() {
    if (closed.compareAndSet(false, true)) {
      NetworkThread.execute(channel.eventLoop(), this::farewell);
    }
  }

  private ChannelFuture flush() {
    scheduled.set(false);
    StringBuilder together = new StringBuilder();
    for (String bytes = waiting.poll(); bytes != null; bytes = waiting.poll()) {
      together.append(bytes);
    }
    byte[] bytes = together.toString().getBytes(StandardCharsets.ISO_8859_1);
    return channel
        .writeAndFlush(Unpooled.wrappedBuffer(bytes))
        .addListener(done -> count(-bytes.length));
  }

  private void count(int more) {
    if (unsent.addAndGet(more) >= 0) {
      together.add(more);
    }
  }

  /** How many bytes wait; any thread. */
  long unsent() {
    return Math.max(0, unsent.get());
  }

  /** The client has gone, and nothing waits for it any more; on the network thread. */
  void gone() {
    closed.set(true);
    together.add(-unsent.getAndSet(GONE));
    together.go();
  }

  /**
   * Ends the stream before closing, and reads on until the client has hung up: closing a socket
   * that has unread input would destroy output which is still on its way.
   */
  private void farewell() {
    channel.config().setAutoRead(true);
    NetworkThread.close(channel, FAREWELL_SECONDS);
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
