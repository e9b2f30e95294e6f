package org.urbi.kernel.outside;

import static java.util.Objects.requireNonNull;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.message.Message;

/** An open connection: one thread reads, another one writes. */
public final class SocketConnection implements Closeable {
  /** Receives the input, on the kernel thread and in order. */
  public interface Listener {
    void received(byte[] bytes);

    /**
     * The input has ended.
     *
     * @param error what went wrong, or null when the other end has closed the connection
     */
    void ended(@Nullable String error);
  }

  private static final int CHUNK = 1 << 16;

  /** How many received bytes may wait to be consumed. */
  private static final int AHEAD = 1 << 22;

  private final Outside outside;
  private final InputStream in;
  private final PipeSink sink;
  private final Closeable connection;
  private final boolean network;
  private @Nullable Listener listener;
  private int number;

  /**
   * The received bytes that wait to be consumed; guarded by this object, on which the reader waits.
   */
  private int ahead;

  private volatile boolean closed;

  /**
   * @param connection closed at the end
   * @param network whether reading waits for the network, not inside the operating system
   */
  SocketConnection(
      Outside outside, InputStream in, OutputStream out, Closeable connection, boolean network) {
    this.outside = outside;
    this.in = in;
    this.connection = connection;
    this.network = network;
    sink = new PipeSink(outside, closing(out), network);
  }

  /** A stream whose end closes the connection: the writing thread does so after the last byte. */
  private OutputStream closing(OutputStream out) {
    return new OutputStream() {
      @Override
      public void write(int b) throws IOException {
        out.write(b);
      }

      @Override
      public void write(byte[] bytes, int from, int length) throws IOException {
        out.write(bytes, from, length);
      }

      @Override
      public void flush() throws IOException {
        out.flush();
      }

      @Override
      public void close() throws IOException {
        connection.close();
        outside.closed(connection);
      }
    };
  }

  /** A connection of a replay, to which nothing is sent and from which only the journal reads. */
  static SocketConnection replayed(Outside outside, boolean network) {
    return new SocketConnection(
        outside, InputStream.nullInputStream(), OutputStream.nullOutputStream(), () -> {}, network);
  }

  /** Begins to listen. */
  public void open(Listener to) {
    listener = to;
    number = outside.inbox().register(this::take);
    outside.opened(connection);
    outside.scheduler().pace().begin();
    if (network) {
      outside.startVirtual(this::read);
    } else {
      outside.start(this::read);
    }
  }

  private void read() {
    try {
      byte[] buffer = new byte[CHUNK];
      int length;
      while (hasRoom() && (length = in.read(buffer)) >= 0) {
        byte[] bytes = Arrays.copyOf(buffer, length);
        synchronized (this) {
          ahead += length;
        }
        outside.inbox().post(new Message.BytesArrived(number, bytes));
      }
      outside.inbox().post(new Message.BytesEnded(number, null));
    } catch (IOException e) {
      outside.inbox().post(new Message.BytesEnded(number, closed ? null : e.getMessage()));
    } catch (Throwable e) {
      FailureLog.internal("reading a connection", e);
      outside.inbox().post(new Message.BytesEnded(number, FailureLog.text(e)));
    }
  }

  private void take(Message message) {
    switch (message) {
      case Message.BytesArrived arrived -> listener().received(arrived.bytes());
      case Message.BytesEnded end -> end(end.error());
      default -> throw new IllegalArgumentException(message.toString());
    }
  }

  private Listener listener() {
    return requireNonNull(listener, "set before the first message is asked for");
  }

  private synchronized boolean hasRoom() {
    try {
      while (ahead >= AHEAD && !closed) {
        wait();
      }
    } catch (InterruptedException e) {
      return false;
    }
    return !closed;
  }

  private void end(@Nullable String error) {
    outside.inbox().forget(number);
    outside.scheduler().pace().end();
    listener().ended(error);
    close();
  }

  /** That number of received bytes has been consumed. */
  public synchronized void consumed(int bytes) {
    ahead -= bytes;
    notifyAll();
  }

  /** Sends bytes in the background; the job waits while too many are pending. */
  public void write(Job job, byte[] bytes) throws IOException {
    sink.write(job, bytes);
  }

  /** Makes the job wait until everything has been sent. */
  public void flush(Job job) throws IOException {
    sink.flush(job);
  }

  /** Closes the connection as soon as everything has been sent. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    sink.close();
    if (!network && listener != null) {
      // What is still to be sent may wait for ever; nothing more is to be read.
      outside.start(() -> Outside.closeQuietly(in));
      outside.inbox().post(new Message.BytesEnded(number, null));
    }
  }
}
