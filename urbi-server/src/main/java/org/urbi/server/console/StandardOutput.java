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

/**
 * Writes the output of lobbies to a stream on a thread of its own, so that the kernel does not wait
 * for a slow pipe, and many short lines become one write. The kernel waits only when more than
 * {@link #LIMIT} bytes are pending: output to a file or a pipe is never dropped.
 *
 * <p>It uses no lock: a job may add output, and a job that waits for a lock would let other jobs
 * run.
 */
public final class StandardOutput implements ConsoleOutput {
  private static final long LIMIT = 16L << 20;
  private static final long PAUSE_NANOSECONDS = 50_000;

  private final OutputStream stream;
  private final Consumer<IOException> lost;
  private final Thread writer;
  private final Queue<String> waiting = new ConcurrentLinkedQueue<>();
  private final AtomicLong size = new AtomicLong();
  private volatile boolean closed;
  private volatile boolean broken;

  /**
   * @param lost called once when writing fails; later output is dropped
   */
  public StandardOutput(OutputStream stream, Consumer<IOException> lost) {
    this.stream = stream;
    this.lost = lost;
    writer = Thread.ofPlatform().daemon().name("urbi-output").unstarted(this::write);
    writer.start();
  }

  @Override
  public void add(String bytes) {
    while (size.get() > LIMIT && !broken) {
      pause();
    }
    if (!broken) {
      waiting.add(bytes);
      if (size.getAndAdd(bytes.length()) == 0) {
        LockSupport.unpark(writer);
      }
    }
  }

  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(writer);
    while (writer.isAlive()) {
      pause();
    }
  }

  /** Waits a little. A job must not be switched out here, so it spins. */
  private static void pause() {
    if (Thread.currentThread().isVirtual()) {
      Thread.onSpinWait();
    } else {
      LockSupport.parkNanos(PAUSE_NANOSECONDS);
    }
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
