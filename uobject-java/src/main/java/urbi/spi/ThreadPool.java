package urbi.spi;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import urbi.thread.GuardedThreads;

/** The threads of one context. They are platform threads: their code may block. */
public final class ThreadPool implements Executor, AutoCloseable {
  /** A thread without a task ends after that time. */
  private static final Duration KEPT = Duration.ofMinutes(1);

  private final ExecutorService threads;
  private final ArrayDeque<Runnable> waiting = new ArrayDeque<>();
  private int limit;
  private int running;

  /**
   * @param name what the threads are called
   */
  public ThreadPool(String name) {
    threads = GuardedThreads.SDK.pool(name, KEPT);
  }

  /** Limits the number of threads that run at a time; 0 for any number. */
  public void setLimit(int most) {
    if (most < 0) {
      throw new IllegalArgumentException("negative number of threads: " + most);
    }
    synchronized (waiting) {
      limit = most;
      startWaiting();
    }
  }

  @Override
  public void execute(Runnable task) {
    synchronized (waiting) {
      waiting.add(task);
      startWaiting();
    }
  }

  private void startWaiting() {
    while (!waiting.isEmpty() && (limit == 0 || running < limit)) {
      Runnable task = waiting.poll();
      running++;
      try {
        threads.execute(() -> run(task));
      } catch (RejectedExecutionException e) {
        // The context has ended.
        running--;
      } catch (OutOfMemoryError e) {
        // The system has no thread left.
        running--;
        if (running == 0) {
          throw e;
        }
        // It gets the first of these that has done its task.
        waiting.addFirst(task);
        return;
      }
    }
  }

  private void run(Runnable task) {
    try {
      task.run();
    } finally {
      synchronized (waiting) {
        running--;
        startWaiting();
      }
    }
  }

  /** Starts nothing more; interrupts what runs. */
  @Override
  public void close() {
    threads.shutdownNow();
  }
}
