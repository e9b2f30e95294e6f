package org.urbi.server.net;

import io.netty.buffer.Unpooled;
import io.netty.channel.Channel;
import io.netty.channel.socket.DuplexChannel;
import io.netty.handler.ssl.SslHandler;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Deque;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;

/**
 * The output queue of one client. The kernel adds output and continues; the network thread sends it
 * as fast as the client reads. A client that does not read is disconnected when the limit is
 * exceeded, because the kernel waits for nobody. The class uses no lock: a job may add output, and
 * a job that waits for a lock would let other jobs run.
 */
final class ClientOutput {
  /** How long a client may take to read the rest and to close its side. */
  private static final int CLOSE_SECONDS = 5;

  /** How many bytes are sent at a time, at least if there are so many. */
  private static final int PIECE = 1 << 16;

  /** When sending is tried again for which there was no memory. */
  private static final int RETRY_MILLISECONDS = 100;

  /** Marks a closed queue; so negative that adding bytes never makes it positive. */
  private static final long GONE = Long.MIN_VALUE / 2;

  private final Channel channel;
  private volatile long limit;
  private final TotalOutput totalOutput;
  private final Runnable onOverflow;
  private final Deque<String> waiting = new ConcurrentLinkedDeque<>();

  // The network thread alone uses these.
  private final ArrayList<String> taken = new ArrayList<>();
  private boolean ending;

  private final Runnable send = this::sendOrRetry;
  private final AtomicLong unsent = new AtomicLong();
  private final AtomicBoolean scheduled = new AtomicBoolean();
  private final AtomicBoolean closed = new AtomicBoolean();

  /**
   * @param limit how many bytes may wait before the next one is too much
   * @param totalOutput what waits for all clients
   * @param onOverflow called once, by whoever adds, when there is too much
   */
  ClientOutput(Channel channel, long limit, TotalOutput totalOutput, Runnable onOverflow) {
    this.channel = channel;
    this.limit = limit;
    this.totalOutput = totalOutput;
    totalOutput.clientAdded();
    this.onOverflow = onOverflow;
  }

  /** Raises the limit to that many bytes, if it is lower. */
  void allow(long bytes) {
    limit = Math.max(limit, bytes);
  }

  /** Adds a text in which each character is a byte. Any thread may call this; it never waits. */
  void add(String bytes) {
    if (closed.get()) {
      return;
    }
    if (unsent.get() > limit || totalOutput.isTooMuch(unsent.get())) {
      if (closed.compareAndSet(false, true)) {
        waiting.clear();
        onOverflow.run();
        channel.close();
      }
      return;
    }
    count(bytes.length());
    boolean added = false;
    try {
      added = waiting.add(bytes);
      schedule();
    } catch (OutOfMemoryError e) {
      // Either nothing has happened, or the network thread has taken them all the same.
      if (!added || waiting.removeLastOccurrence(bytes)) {
        count(-bytes.length());
        throw e;
      }
    }
  }

  private void schedule() {
    if (scheduled.compareAndSet(false, true)) {
      try {
        NetworkThread.execute(channel.eventLoop(), send);
      } catch (OutOfMemoryError e) {
        scheduled.set(false);
        throw e;
      }
    }
  }

  /**
   * Sends the rest, then closes the connection. Any thread may call this. Nothing can be added
   * afterwards.
   */
  void finish() {
    if (closed.compareAndSet(false, true)) {
      try {
        NetworkThread.execute(channel.eventLoop(), this::closeGracefully);
      } catch (OutOfMemoryError e) {
        // It is closed when there is memory again.
        closed.set(false);
        throw e;
      }
    }
  }

  private static void endOutput(DuplexChannel channel) {
    SslHandler tls = channel.pipeline().get(SslHandler.class);
    if (tls == null) {
      channel.shutdownOutput();
    } else {
      tls.closeOutbound().addListener(told -> channel.shutdownOutput());
    }
  }

  /** The socket takes more; on the network thread. */
  void resume() {
    if (!waiting.isEmpty() || ending) {
      schedule();
    }
  }

  private void sendOrRetry() {
    scheduled.set(false);
    try {
      send();
    } catch (OutOfMemoryError e) {
      channel.eventLoop().schedule(send, RETRY_MILLISECONDS, TimeUnit.MILLISECONDS);
    }
  }

  /**
   * Sends what waits, as much as the socket takes: the rest would only be copied, while other
   * clients wait.
   */
  private void send() {
    while (channel.isWritable() && takeWaiting()) {
      StringBuilder joined = new StringBuilder();
      taken.forEach(joined::append);
      byte[] bytes = joined.toString().getBytes(StandardCharsets.ISO_8859_1);
      taken.clear();
      channel
          .writeAndFlush(Unpooled.wrappedBuffer(bytes))
          .addListener(done -> count(-bytes.length));
    }
    if (ending && waiting.isEmpty() && taken.isEmpty()) {
      ending = false;
      channel.writeAndFlush(Unpooled.EMPTY_BUFFER).addListener(done -> endOutput());
    }
  }

  /** Takes so much as is sent at a time; false if there is nothing. */
  private boolean takeWaiting() {
    int size = 0;
    for (String bytes : taken) {
      size += bytes.length();
    }
    while (size < PIECE && !waiting.isEmpty()) {
      taken.ensureCapacity(taken.size() + 1);
      String bytes = waiting.poll();
      if (bytes != null) {
        taken.add(bytes);
        size += bytes.length();
      }
    }
    return !taken.isEmpty();
  }

  private void count(int more) {
    if (unsent.addAndGet(more) >= 0) {
      totalOutput.add(more);
    }
  }

  /** The number of bytes in the queue. Any thread may call this. */
  long unsent() {
    return Math.max(0, unsent.get());
  }

  /** The client has disconnected: discards the queue. Called on the network thread. */
  void gone() {
    closed.set(true);
    ending = false;
    waiting.clear();
    taken.clear();
    totalOutput.add(-unsent.getAndSet(GONE));
    totalOutput.clientRemoved();
  }

  /**
   * Ends the output before closing, and reads until the client closes its side: closing a socket
   * with unread input would destroy output that is still in transit.
   */
  private void closeGracefully() {
    channel.config().setAutoRead(true);
    NetworkThread.close(channel, CLOSE_SECONDS);
    ending = true;
    sendOrRetry();
  }

  private void endOutput() {
    if (channel instanceof DuplexChannel duplex && !duplex.isInputShutdown()) {
      endOutput(duplex);
    } else {
      channel.close();
    }
  }
}
