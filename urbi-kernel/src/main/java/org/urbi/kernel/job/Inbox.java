package org.urbi.kernel.job;

import java.io.IOException;
import java.nio.channels.Selector;
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
  private volatile Selector selecting;

  /** Leaves a message; from any thread. Messages are taken in the order in which they came. */
  public void post(Runnable message) {
    messages.add(message);
    filled = true;
    Thread sleeper = waiting;
    if (sleeper != null) {
      LockSupport.unpark(sleeper);
    }
    Selector listener = selecting;
    if (listener != null) {
      listener.wakeup();
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
   * Waits for a message or for a channel, for at most so many milliseconds.
   *
   * @throws IOException if the selector fails
   */
  public void await(Selector selector, long milliseconds) throws IOException {
    selecting = selector;
    try {
      if (!filled) {
        selector.select(milliseconds);
      }
    } finally {
      selecting = null;
    }
  }
}
