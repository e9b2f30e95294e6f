package urbi;

import java.util.ArrayDeque;
import java.util.concurrent.Executor;

/**
 * A queue of threaded calls that exclude one another: they run one at a time, in the order of their
 * arrival.
 */
public final class UTaskQueue {
  private final ArrayDeque<Runnable> waiting = new ArrayDeque<>();
  private boolean running;

  /**
   * Runs a task on a thread, when those before it have ended.
   *
   * @param most how many tasks there may be in all, this one included; 0 for any number
   * @return false if there are too many: the task is dropped
   */
  public boolean execute(Executor threads, int most, Runnable task) {
    synchronized (waiting) {
      int size = waiting.size() + (running ? 1 : 0);
      if (most > 0 && size >= most) {
        return false;
      }
      if (running) {
        waiting.add(task);
        return true;
      }
      running = true;
    }
    try {
      start(threads, task);
    } catch (Error e) {
      // There is no thread for it now; there may be one for the next.
      synchronized (waiting) {
        running = false;
      }
      throw e;
    }
    return true;
  }

  private void start(Executor threads, Runnable task) {
    threads.execute(() -> {
      try {
        task.run();
      } finally {
        next(threads);
      }
    });
  }

  private void next(Executor threads) {
    Runnable task;
    synchronized (waiting) {
      task = waiting.poll();
      if (task == null) {
        running = false;
        return;
      }
    }
    start(threads, task);
  }
}
