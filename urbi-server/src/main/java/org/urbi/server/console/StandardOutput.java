package org.urbi.server.console;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;

/**
 * Writes the output of lobbies to a stream on a thread of its own, so that the kernel does not wait
 * for a slow pipe, and many short lines become one write. The kernel waits only when more than
 * {@link #LIMIT} bytes are pending: output to a file or a pipe is never dropped. A server has
 * others to answer: it waits for a moment, and then drops output until there is room, and says so.
 *
 * <p>It uses no lock: a job may add output, and a job that waits for a lock would let other jobs
 * run.
 */
public final class StandardOutput implements ConsoleOutput {
  private static final long LIMIT = 16L << 20;
  private static final long PAUSE_NANOSECONDS = 50_000;

  /** How long a server waits for room, in nanoseconds. */
  private static final long PATIENCE = 100_000_000;

  /** How long a server waits at its end for what has not been written, in nanoseconds. */
  private static final long LAST_PATIENCE = 1_000_000_000;

  private final Clock clock = new SystemClock();
  private final boolean serves;

  private final OutputStream stream;
  private final Consumer<IOException> lost;
  private final Thread writer;
  private final Queue<String> waiting = new ConcurrentLinkedQueue<>();
  private final AtomicLong size = new AtomicLong();

  /** How many bytes were dropped since there was room; for the kernel thread alone. */
  private long dropped;

  private volatile boolean closed;
  private volatile boolean broken;

  /**
   * @param serves whether there are others to answer, so that the kernel must not wait for long
   * @param lost called once when writing fails; later output is dropped
   */
  public StandardOutput(OutputStream stream, boolean serves, Consumer<IOException> lost) {
    this.stream = stream;
    this.serves = serves;
    this.lost = lost;
    writer = FailureLog.THREADS.platform("urbi-output", this::write);
    writer.start();
  }

  @Override
  public void add(String bytes) {
    if (size.get() > LIMIT && (dropped > 0 || !waitForRoom())) {
      dropped += bytes.length();
    } else if (!broken) {
      if (dropped > 0) {
        append(dropped + " bytes of output were dropped, nobody has read them\n");
        dropped = 0;
      }
      append(bytes);
    }
  }

  private void append(String bytes) {
    waiting.add(bytes);
    if (size.getAndAdd(bytes.length()) == 0) {
      LockSupport.unpark(writer);
    }
  }

  /** Returns whether there is room, or nothing is written any more. */
  private boolean waitForRoom() {
    long began = clock.now();
    while (size.get() > LIMIT && !broken) {
      if (serves && clock.now() - began > PATIENCE) {
        return false;
      }
      pause();
    }
    return true;
  }

  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(writer);
    long began = clock.now();
    while (writer.isAlive() && !(serves && clock.now() - began > LAST_PATIENCE)) {
      pause();
    }
  }

  /** Waits a little. */
  private static void pause() {
    LockSupport.parkNanos(PAUSE_NANOSECONDS);
  }

  private void write() {
    StringBuilder together = new StringBuilder();
    try {
      while (true) {
        boolean last = closed;
        for (String bytes = waiting.poll(); bytes != null; bytes = waiting.poll()) {
          together.append(bytes);
        }
        if (!together.isEmpty()) {
          stream.write(together.toString().getBytes(StandardCharsets.ISO_8859_1));
          stream.flush();
          size.addAndGet(-together.length());
          together = new StringBuilder();
        } else if (last) {
          return;
        } else if (size.get() == 0) {
          LockSupport.park();
        }
      }
    } catch (IOException e) {
      broken = true;
      lost.accept(e);
    } catch (Throwable failure) {
      // Wakes those who wait for room: there will never be any.
      broken = true;
      FailureLog.internal("the standard output", failure);
    }
  }
}
