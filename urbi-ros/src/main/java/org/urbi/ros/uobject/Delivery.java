package org.urbi.ros.uobject;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * What has come from the network and urbiscript has not seen yet: no more than the newest ones, or
 * all, for which the network waits then. One call is on its way to the kernel at a time.
 */
final class Delivery<T> {
  /** So many wait where all are wanted, and with them whoever sends more. */
  private static final int MOST = 1000;

  /** So many the kernel takes at once: what else it has to do has its turn then. */
  private static final int TURN = 100;

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

  /**
   * Hands what waits to the kernel, which calls this. What is too much for a turn, and what comes
   * after one that the taker cannot bear, has another call.
   *
   * @return whether that was all
   */
  boolean take(Consumer<? super T> taker) {
    boolean finished = false;
    try {
      for (int taken = 0; taken < TURN && !finished; taken++) {
        T next = next();
        if (next == null) {
          finished = true;
        } else {
          taker.accept(next);
        }
      }
    } finally {
      if (!finished) {
        call.run();
      }
    }
    return finished;
  }

  private synchronized @Nullable T next() {
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
