package org.urbi.kernel.outside;

import static java.util.Objects.requireNonNullElseGet;

import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.message.Message;

/**
 * Writes to a pipe or a connection, whose writers may have to wait. A thread of its own, which is
 * started at the first call, writes in the order of the calls.
 */
public final class PipeSink implements ByteSink {
  private static final byte[] END = new byte[0];

  /** How many bytes may wait to be written before jobs have to wait. */
  private static final int LARGE = 1 << 20;

  private final Outside outside;
  private final OutputStream out;
  private final int number;
  private final WaitingJobs waiters = new WaitingJobs();
  private final LinkedBlockingQueue<byte[]> queue = new LinkedBlockingQueue<>();
  private final boolean network;
  private final AtomicBoolean started = new AtomicBoolean();
  private final CompletableFuture<@Nullable Void> ended = new CompletableFuture<>();
  private int underWay;
  private boolean closed;
  private @Nullable String failure;

  /**
   * @param out null in a replay
   * @param network whether it is a connection, not a file of the operating system
   */
  public PipeSink(Outside outside, @Nullable OutputStream out, boolean network) {
    this.outside = outside;
    this.out = requireNonNullElseGet(out, OutputStream::nullOutputStream);
    this.network = network;
    number = outside.inbox().register(this::take);
  }

  private void enqueue(byte[] bytes) {
    queue.add(bytes);
    if (started.compareAndSet(false, true)) {
      if (network) {
        outside.startVirtual(this::writeAll);
      } else {
        outside.start(this::writeAll);
      }
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
        outside.inbox().post(new Message.BytesWritten(number, bytes.length));
      }
    } catch (IOException e) {
      outside.inbox().post(new Message.WritingFailed(number, Outside.reason(e)));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (Throwable e) {
      FailureLog.internal("writing a connection", e);
      outside.inbox().post(new Message.WritingFailed(number, FailureLog.text(e)));
    } finally {
      ended.complete(null);
    }
  }

  private void take(Message message) {
    switch (message) {
      case Message.BytesWritten written -> underWay -= written.count();
      case Message.WritingFailed broken -> failure = broken.error();
      default -> throw new IllegalArgumentException(message.toString());
    }
    waiters.wake();
  }

  @Override
  public void write(Job job, byte[] bytes) throws IOException {
    if (bytes.length > 0) {
      waiters.await(job, () -> underWay < LARGE || failure != null || closed);
      check();
      underWay += bytes.length;
      enqueue(bytes);
    }
  }

  @Override
  public void flush(Job job) throws IOException {
    waiters.await(job, () -> underWay == 0 || failure != null || closed);
    check();
  }

  private void check() throws IOException {
    if (failure != null) {
      throw new IOException(failure);
    }
    if (closed) {
      throw new IOException(Problem.CONNECTION_CLOSED.text());
    }
  }

  /**
   * Closes it from any thread, as soon as what is queued is written or has failed.
   *
   * @return done when it is closed
   */
  CompletableFuture<?> end() {
    enqueue(END);
    return ended;
  }

  /** The reader has gone: writing fails from now on. */
  void readerGone() {
    outside.inbox().forget(number);
    if (!closed && failure == null) {
      failure = Problem.BROKEN_PIPE.text();
      waiters.wake();
    }
  }

  /** Closes it as soon as everything is written. */
  @Override
  public void close() {
    if (!closed) {
      closed = true;
      enqueue(END);
      outside.inbox().forget(number);
      waiters.wake();
    }
  }
}
