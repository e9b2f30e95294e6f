package org.urbi.kernel.outside;

import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.LinkedBlockingQueue;
import org.urbi.kernel.job.Job;

/**
 * Writes to what may let its writers wait: a pipe, a connection. A thread does the writing, in the
 * order of the calls.
 */
public final class PipeSink implements ByteSink {
  private static final byte[] END = new byte[0];

  /** How much may wait to be written before jobs wait, too. */
  private static final int LARGE = 1 << 20;

  private final Outside outside;
  private final OutputStream out;
  private final Waiters waiters = new Waiters();
  private final LinkedBlockingQueue<byte[]> queue = new LinkedBlockingQueue<>();
  private int underWay;
  private boolean closed;
  private IOException failure;

  /**
   * @param network whether it is a connection, not a file of the operating system
   */
  public PipeSink(Outside outside, OutputStream out, boolean network) {
    this.outside = outside;
    this.out = out;
    if (network) {
      outside.startVirtual(this::writeAll);
    } else {
      outside.start(this::writeAll);
    }
  }

  private void writeAll() {
    try (out) {
      byte[] bytes;
      while ((bytes = queue.take()) != END) {
        out.write(bytes);
        if (queue.isEmpty()) {
          out.flush();
        }
        int written = bytes.length;
        outside.post(() -> written(written, null));
      }
    } catch (IOException e) {
      outside.post(() -> written(0, e));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void written(int bytes, IOException broken) {
    underWay -= bytes;
    if (broken != null) {
      failure = broken;
    }
    waiters.wake();
  }

  @Override
  public void write(Job job, byte[] bytes) throws IOException {
    if (bytes.length > 0) {
      waiters.await(job, () -> underWay < LARGE || failure != null || closed);
      check();
      underWay += bytes.length;
      queue.add(bytes);
    }
  }

  @Override
  public void flush(Job job) throws IOException {
    waiters.await(job, () -> underWay == 0 || failure != null || closed);
    check();
  }

  private void check() throws IOException {
    if (failure != null) {
      throw failure;
    }
    if (closed) {
      throw new IOException("connection is closed");
    }
  }

  /** Closes it as soon as all that was given to it is written. */
  @Override
  public void close() {
    if (!closed) {
      closed = true;
      queue.add(END);
      waiters.wake();
    }
  }
}
