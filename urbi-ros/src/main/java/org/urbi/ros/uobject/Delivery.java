package org.urbi.ros.uobject;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/**
 * What has come from the network and urbiscript has not seen yet: no more than the newest ones, or
 * all, for which the network waits then. One call is on its way to the kernel at a time.
 */
final class Delivery<T> {
  /** So many wait where all are wanted, and with them whoever sends more. */
  private static final int MOST = 1000;

  private final Deque<T> waiting = new ArrayDeque<>();
  private final Runnable call;
  private int depth = 1;
  private boolean called;
  private boolean ended;

  /**
   * @param call has the kernel take what there is, soon; does not wait
   */
  Delivery(Runnable call) {
    this.call = call;
  }

  /**
   * Begins.
   *
   * @param most how many wait at most, the oldest go first; 0 for all
   */
  synchronized void begin(int most) {
    waiting.clear();
    depth = most;
    ended = false;
  }

  /** Something has come; called by threads of the network. */
  void offer(T value) {
    synchronized (this) {
      if (depth == 0) {
        awaitRoom();
      } else {
        while (waiting.size() >= depth) {
          waiting.removeFirst();
        }
      }
      if (ended) {
        return;
      }
      waiting.addLast(value);
      if (called) {
        return;
      }
      called = true;
    }
    call.run();
  }

  private void awaitRoom() {
    try {
      while (waiting.size() >= MOST && !ended) {
        wait();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** The next one for the kernel, which calls it until there is none (null). */
  synchronized @Nullable T next() {
    T next = waiting.pollFirst();
    if (next == null) {
      called = false;
    }
    notifyAll();
    return next;
  }

  /** Forgets what waits. */
  synchronized void end() {
    ended = true;
    waiting.clear();
    notifyAll();
  }
}
