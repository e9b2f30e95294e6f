package org.urbi.kernel.outside;

import static java.util.Objects.requireNonNullElseGet;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.message.Message;

/**
 * The bytes of a pipe, or of anything else whose readers may have to wait. A thread reads ahead up
 * to a limit, so that the program at the other end can continue, and end.
 */
public final class PipeSource implements ByteSource {
  private static final int CHUNK = 1 << 13;

  /** How many bytes are read ahead. */
  private static final int AHEAD = 1 << 24;

  private final Outside outside;
  private final InputStream in;
  private final int number;
  private final WaitingJobs waiters = new WaitingJobs();
  private final ArrayDeque<byte[]> chunks = new ArrayDeque<>();
  private int position;
  private boolean ended;
  private @Nullable String failure;

  /** How many bytes were read ahead; guarded by this object, on which the thread waits. */
  private int ahead;

  private boolean writerGone;
  private boolean closed;
  private final CompletableFuture<@Nullable Void> told = new CompletableFuture<>();

  /**
   * Starts to read.
   *
   * @param in null in a replay
   */
  public PipeSource(Outside outside, @Nullable InputStream in) {
    this.outside = outside;
    this.in = requireNonNullElseGet(in, InputStream::nullInputStream);
    number = outside.inbox().register(this::take);
    outside.start(this::readAhead);
  }

  private void readAhead() {
    String error = null;
    try (in) {
      byte[] buffer = new byte[CHUNK];
      int read;
      while (hasRoom() && (read = in.read(buffer)) >= 0) {
        byte[] chunk = Arrays.copyOf(buffer, read);
        synchronized (this) {
          ahead += read;
        }
        outside.inbox().post(new Message.BytesArrived(number, chunk));
      }
    } catch (IOException e) {
      error = Outside.reason(e);
    } catch (Throwable e) {
      FailureLog.internal("reading a pipe", e);
      error = FailureLog.text(e);
    }
    tellEnd(error);
  }

  /** Tells the end: what is read later is dropped. */
  private void tellEnd(@Nullable String error) {
    outside.inbox().post(new Message.BytesEnded(number, error));
    told.complete(null);
  }

  /**
   * Nobody writes any more: reads the rest, however much is read ahead. Called by any thread.
   *
   * @return done when the pipe is closed and its end told
   */
  synchronized CompletableFuture<?> end() {
    writerGone = true;
    notifyAll();
    return told;
  }

  /** Gives up waiting for the end, because somebody else holds the pipe open; from any thread. */
  void abandon() {
    if (!told.isDone()) {
      close();
      tellEnd(null);
    }
  }

  private void take(Message message) {
    switch (message) {
      case Message.BytesArrived arrived -> chunks.add(arrived.bytes());
      case Message.BytesEnded end -> {
        outside.inbox().forget(number);
        ended = true;
        failure = end.error();
      }
      default -> throw new IllegalArgumentException(message.toString());
    }
    waiters.wake();
  }

  private synchronized boolean hasRoom() {
    try {
      while (ahead >= AHEAD && !writerGone && !closed) {
        wait();
      }
    } catch (InterruptedException e) {
      return false;
    }
    return !closed;
  }

  @Override
  public int read(Job job) throws IOException {
    waiters.await(job, () -> !chunks.isEmpty() || ended);
    byte[] first = chunks.peek();
    if (first == null) {
      if (failure != null) {
        throw new IOException(failure);
      }
      return -1;
    }
    int next = first[position++] & 0xff;
    if (position == first.length) {
      chunks.poll();
      position = 0;
      synchronized (this) {
        ahead -= first.length;
        notifyAll();
      }
    }
    return next;
  }

  @Override
  public synchronized void close() {
    closed = true;
    notifyAll();
    // The reading thread may be blocked for ever, so another thread closes the pipe.
    outside.start(() -> Outside.closeQuietly(in));
  }
}
