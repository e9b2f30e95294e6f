package org.urbi.server.console;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.locks.LockSupport;
import org.urbi.kernel.log.FailureLog;

/**
 * The messages of a server, which somebody may read or not: who writes one never waits. They are
 * kept in a small buffer, and written to the stream by a thread of its own. What has no room is
 * lost, which is told when there is room again.
 *
 * <p>To write takes no memory, because a message may be about the lack of it.
 */
public final class ErrorOutput implements AutoCloseable {
  private static final int ROOM = 1 << 16;

  /** How many bytes the JDK writes to a file without taking memory for them. */
  private static final int PIECE = 1 << 13;

  /** How long it waits for memory, in nanoseconds. */
  private static final long PAUSE = 10_000_000;

  /** How long the end waits until all is written, in milliseconds. */
  private static final int LAST_WORDS = 1000;

  private static final byte[] LOST =
      "urbi: messages are lost here, because nobody has read them\n"
          .getBytes(StandardCharsets.US_ASCII);

  private final OutputStream stream;
  private final byte[] buffer = new byte[ROOM];
  private final Thread writer;
  private final PrintStream messages;

  /** How many bytes were put into the buffer; changed by who writes a message. */
  private volatile long put;

  /** How many bytes were taken out again; changed by the writer. */
  private volatile long taken;

  private volatile boolean over;
  private boolean losing;

  /**
   * @param stream may block, or fail
   */
  public ErrorOutput(OutputStream stream) {
    this.stream = stream;
    writer = FailureLog.THREADS.platform("urbi-errors", this::write);
    writer.start();
    // It lets in one at a time.
    messages = new PrintStream(new Filler(), true, StandardCharsets.UTF_8);
  }

  /** Where messages are written to, by any thread. */
  public PrintStream messages() {
    return messages;
  }

  /** Waits until everybody has got the messages so far; but not long. */
  public void drain() {
    try {
      for (int i = 0; i < LAST_WORDS && put != taken && !over; i++) {
        Thread.sleep(1);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Writes what is left, if the stream takes it. */
  @Override
  public void close() {
    messages.flush();
    drain();
    over = true;
    LockSupport.unpark(writer);
  }

  private final class Filler extends OutputStream {
    @Override
    public void write(int octet) {
      write(new byte[] {(byte) octet}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int from, int length) {
      long room = ROOM - (put - taken);
      if (losing && room > LOST.length + length) {
        losing = false;
        put(LOST, 0, LOST.length);
      }
      if (losing || length > room) {
        losing = true;
      } else {
        put(bytes, from, length);
      }
      LockSupport.unpark(writer);
    }
  }

  private void put(byte[] bytes, int from, int length) {
    int at = (int) (put % ROOM);
    int first = Math.min(length, ROOM - at);
    System.arraycopy(bytes, from, buffer, at, first);
    System.arraycopy(bytes, from + first, buffer, 0, length - first);
    put += length;
  }

  private void write() {
    try {
      while (!over) {
        int at = (int) (taken % ROOM);
        int length = (int) Math.min(put - taken, Math.min(PIECE, ROOM - at));
        if (length == 0) {
          LockSupport.park(this);
        } else if (isWritten(at, length)) {
          taken += length;
        } else {
          LockSupport.parkNanos(this, PAUSE);
        }
      }
    } catch (Throwable failure) {
      // Nobody can be told.
      over = true;
    }
  }

  private boolean isWritten(int at, int length) throws IOException {
    try {
      stream.write(buffer, at, length);
      stream.flush();
      return true;
    } catch (OutOfMemoryError e) {
      // The messages to come are about this.
      return false;
    }
  }
}
