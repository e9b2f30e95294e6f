package org.urbi.kernel.job;

import java.io.IOException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.locks.LockSupport;

/**
 * The one way in: everything that other threads want of the kernel waits here until the next tick
 * begins.
 */
public final class Inbox {
  private final ConcurrentLinkedQueue<Runnable> messages = new ConcurrentLinkedQueue<>();
  private volatile boolean filled;
  private volatile Thread waiting;
  private volatile Waiting elsewhere;

  /** Leaves a message; from any thread. Messages are taken in the order in which they came. */
  public void post(Runnable message) {
    messages.add(message);
    filled = true;
    Thread sleeper = waiting;
    if (sleeper != null) {
      LockSupport.unpark(sleeper);
    }
    Waiting other = elsewhere;
    if (other != null) {
      other.wake();
    }
  }

  boolean isFilled() {
    return filled;
  }

  /** The next message, or null. */
  Runnable poll() {
    Runnable message = messages.poll();
    if (message == null) {
      filled = false;
      // A message may have come between the two.
      message = messages.poll();
      if (message != null) {
        filled = true;
      }
    }
    return message;
  }

  /** Waits for a message, for at most so many nanoseconds. */
  void await(long nanoseconds) {
    waiting = Thread.currentThread();
    try {
      if (!filled) {
        LockSupport.parkNanos(this, nanoseconds);
      }
    } finally {
      waiting = null;
    }
  }

  /**
   * Waits for a message in another way, for at most so many milliseconds.
   *
   * @throws IOException if that way fails
   */
  public void await(Waiting how, long milliseconds) throws IOException {
    elsewhere = how;
    try {
      if (!filled) {
        how.await(milliseconds);
      }
    } finally {
      elsewhere = null;
    }
  }
}
