package urbi.remote;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import urbi.ServerConnection;
import urbi.UClientException;
import urbi.thread.GuardedThreads;
import urbi.thread.InternalFailure;
import urbi.wire.Protocol;
import urbi.wire.WireException;
import urbi.wire.WireInput;
import urbi.wire.WireOutput;

/**
 * The connection of a remote process: frames out and in. Urgent frames are sent by the calling
 * thread; another thread sends all others, many at once.
 */
final class Connection implements AutoCloseable {
  /** More does not wait to be sent: who sends, waits. */
  private static final int MAX_WAITING = 16 << 20;

  private static final int MAX_LINE = 1 << 16;
  private static final int MAX_LINES = 100;

  private final ServerConnection link;
  private final InputStream in;
  private final OutputStream out;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition room = lock.newCondition();
  private final Condition work = lock.newCondition();
  private WireOutput waiting = new WireOutput(1 << 16);
  private WireOutput spare = new WireOutput(1 << 16);
  private boolean writing;
  private boolean writerIdle;
  private volatile @Nullable IOException failure;
  private volatile boolean tooLate;
  private byte[] buffer = new byte[1 << 16];
  private int from;
  private int to;

  /**
   * Connects, and agrees upon the protocol.
   *
   * @throws UClientException if nobody answers, or somebody who does not speak it
   */
  Connection(String host, int port, int milliseconds) {
    link = open(host, port, milliseconds);
    in = link.in();
    out = link.out();
    var agreed = new CountDownLatch(1);
    limit(agreed, milliseconds);
    try {
      out.write(Protocol.request().getBytes(StandardCharsets.US_ASCII));
      awaitAgreement();
    } catch (IOException e) {
      closeSocket();
      throw failed(host, port, tooLate ? late(milliseconds) : e.getMessage(), e);
    } catch (UClientException e) {
      closeSocket();
      throw e;
    } finally {
      agreed.countDown();
    }
    GuardedThreads.SDK.platform("urbi-remote-writer", this::write, this::failed).start();
  }

  private static ServerConnection open(String host, int port, int milliseconds) {
    try {
      return ServerConnection.open(host, port, milliseconds);
    } catch (SocketTimeoutException e) {
      throw failed(host, port, late(milliseconds), e);
    } catch (IOException e) {
      throw failed(host, port, e.getMessage(), e);
    }
  }

  private static String late(int milliseconds) {
    return "no answer within " + milliseconds + " ms";
  }

  private static UClientException failed(
      String host, int port, @Nullable String reason, IOException cause) {
    return new UClientException(
        "cannot connect to " + ServerConnection.name(host, port) + ": " + reason, cause);
  }

  /**
   * Closes the socket unless there is an agreement in time. A deadline of the socket's own would
   * have it ask the system three times for each frame, for ever, instead of once.
   */
  private void limit(CountDownLatch agreed, int milliseconds) {
    Runnable deadline =
        () -> {
          try {
            if (!agreed.await(milliseconds, TimeUnit.MILLISECONDS)) {
              tooLate = true;
              closeSocket();
            }
          } catch (InterruptedException e) {
            // Nobody has the thread to interrupt it.
          }
        };
    GuardedThreads.SDK.virtual("urbi-remote-deadline", deadline, defect -> closeSocket()).start();
  }

  /** Where the server is. */
  InetAddress address() {
    return link.address();
  }

  private void awaitAgreement() throws IOException {
    for (int i = 0; i < MAX_LINES; i++) {
      String line = line();
      int header = line.indexOf("] ");
      if (line.startsWith("[") && header > 0) {
        String text = line.substring(header + 2);
        if (line.substring(0, header).endsWith(":" + Protocol.CHANNEL)) {
          if (text.matches("\\d+( .*)?")) {
            return;
          }
          throw new UClientException(text.replaceFirst("^!!! ", ""));
        }
        if (text.startsWith(Protocol.REQUEST)) {
          throw new UClientException(
              "the server does not speak the UObject protocol: one of another kind, such as those of"
                  + " the SDK of Urbi 2.7, takes components that are linked with that");
        }
      }
    }
    throw new UClientException("this is no Urbi server");
  }

  private String line() throws IOException {
    var line = new StringBuilder();
    for (int c = in.read(); c != '\n'; c = in.read()) {
      if (c < 0) {
        throw new EOFException("the server has closed the connection");
      }
      if (line.length() > MAX_LINE) {
        throw new UClientException("this is no Urbi server");
      }
      line.append((char) c);
    }
    return line.toString();
  }

  /**
   * Adds frames to what is to be sent.
   *
   * @param frames writes whole frames
   * @param urgent whether the bytes are to be on their way when this returns
   * @throws UClientException if there is no connection any more
   */
  void send(Consumer<WireOutput> frames, boolean urgent) {
    lock.lock();
    try {
      while (failure == null && waiting.length() > MAX_WAITING) {
        room.awaitUninterruptibly();
      }
      if (failure != null) {
        throw new UClientException("connection lost: " + failure.getMessage(), failure);
      }
      int before = waiting.length();
      try {
        frames.accept(waiting);
      } catch (RuntimeException e) {
        waiting.abandon();
        throw e;
      }
      if (!writing && (urgent || before > 0 && waiting.length() > MAX_WAITING)) {
        flush();
      } else {
        callWriter();
      }
    } finally {
      lock.unlock();
    }
  }

  /** Sends what is waiting; with the lock, which is released meanwhile. */
  private void flush() {
    WireOutput full = waiting;
    waiting = spare;
    writing = true;
    lock.unlock();
    IOException problem = null;
    try {
      out.write(full.array(), 0, full.length());
    } catch (IOException e) {
      problem = e;
    } catch (RuntimeException | Error e) {
      // Part of it may have been sent: nothing that is sent after it could be understood.
      InternalFailure.log("sending to the server", e);
      problem = new IOException(InternalFailure.text(e), e);
    }
    full.reset();
    lock.lock();
    spare = full;
    writing = false;
    if (problem != null) {
      fail(problem);
    }
    room.signalAll();
    callWriter();
  }

  /** Wakes the writer, if there is something for it to do: that costs more than to write. */
  private void callWriter() {
    if (writerIdle && !writing && waiting.length() > 0) {
      work.signal();
    }
  }

  private void write() {
    lock.lock();
    try {
      while (failure == null) {
        if (waiting.length() > 0 && !writing) {
          flush();
        } else {
          writerIdle = true;
          work.awaitUninterruptibly();
          writerIdle = false;
        }
      }
    } finally {
      lock.unlock();
    }
  }

  /**
   * The next frame: its type is the first octet.
   *
   * @throws IOException when the connection has ended
   */
  WireInput receive() throws IOException {
    fill(4);
    int length = WireInput.frameLength(buffer, from);
    if (length < 1 || length > Protocol.MAX_FRAME) {
      throw new WireException("a frame of " + length + " bytes");
    }
    fill(4 + length);
    WireInput frame = new WireInput(buffer, from + 4, from + 4 + length);
    from += 4 + length;
    return frame;
  }

  /** Has so many bytes in the buffer. What was there before may have to go: it has been read. */
  private void fill(int wanted) throws IOException {
    if (to - from < wanted && buffer.length - from < wanted) {
      // Frames refer to the old array.
      byte[] fresh = new byte[Math.max(1 << 16, wanted)];
      System.arraycopy(buffer, from, fresh, 0, to - from);
      buffer = fresh;
      to -= from;
      from = 0;
    }
    while (to - from < wanted) {
      int size = in.read(buffer, to, buffer.length - to);
      if (size < 0) {
        throw new EOFException("the server has closed the connection");
      }
      to += size;
    }
  }

  private void failed(Throwable defect) {
    lock.lock();
    try {
      fail(new IOException(InternalFailure.text(defect), defect));
    } finally {
      lock.unlock();
    }
  }

  private void fail(IOException problem) {
    if (failure == null) {
      failure = problem;
      closeSocket();
    }
    room.signalAll();
    work.signal();
  }

  private void closeSocket() {
    try {
      link.close();
    } catch (IOException e) {
      // There is nothing left to be closed.
    }
  }

  /** Ends the connection; what has been sent before is sent. */
  @Override
  public void close() {
    lock.lock();
    try {
      if (failure == null && !writing && waiting.length() > 0) {
        flush();
      }
      fail(new IOException("closed"));
    } finally {
      lock.unlock();
    }
  }
}
