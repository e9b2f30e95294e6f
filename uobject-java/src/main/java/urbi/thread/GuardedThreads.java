package urbi.thread;

import java.time.Duration;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.function.Consumer;

/**
 * Makes threads that never end in silence: what their body throws is logged with its stack, and
 * then whoever depends on the thread is told. None keeps the program running.
 */
public final class GuardedThreads {
  /** Makes the threads of components and clients; failures go to {@link System.Logger}. */
  public static final GuardedThreads SDK = new GuardedThreads(InternalFailure::log);

  private final BiConsumer<String, Throwable> log;

  /**
   * @param log is given the part of the program that failed, and what it threw; on any thread
   */
  public GuardedThreads(BiConsumer<String, Throwable> log) {
    this.log = log;
  }

  /** A task that logs what another one throws. */
  public Runnable guarding(String where, Runnable task) {
    return guarding(where, task, failure -> {});
  }

  /**
   * A task that logs what another one throws.
   *
   * @param where the part of the program, for the log
   * @param onFailure is told then: the one that closes what would wait for ever
   */
  public Runnable guarding(String where, Runnable task, Consumer<? super Throwable> onFailure) {
    return () -> {
      try {
        task.run();
      } catch (Throwable failure) {
        try {
          log.accept(where, failure);
        } finally {
          onFailure.accept(failure);
        }
      }
    };
  }

  /** A thread of the system, not started yet. */
  public Thread platform(String name, Runnable body) {
    return platform(name, body, failure -> {});
  }

  /**
   * A thread of the system, not started yet.
   *
   * @param onFailure is told, on that thread, what has ended it
   */
  public Thread platform(String name, Runnable body, Consumer<? super Throwable> onFailure) {
    return platform(name, 0, body, onFailure);
  }

  /**
   * A thread of the system, not started yet.
   *
   * @param stackBytes the size of its stack; 0 for the usual one
   * @param onFailure is told, on that thread, what has ended it
   */
  public Thread platform(
      String name, long stackBytes, Runnable body, Consumer<? super Throwable> onFailure) {
    return Thread.ofPlatform()
        .daemon()
        .name(name)
        .stackSize(stackBytes)
        .unstarted(guarding(where(name), body, onFailure));
  }

  /** A virtual thread, not started yet. */
  public Thread virtual(String name, Runnable body) {
    return virtual(name, body, failure -> {});
  }

  /**
   * A virtual thread, not started yet.
   *
   * @param onFailure is told, on that thread, what has ended it
   */
  public Thread virtual(String name, Runnable body, Consumer<? super Throwable> onFailure) {
    return Thread.ofVirtual().name(name).unstarted(guarding(where(name), body, onFailure));
  }

  /** Executes each task on a virtual thread of its own. */
  public Executor virtualThreads(String name) {
    return task -> virtual(name, task).start();
  }

  /**
   * As many threads as there are tasks at a time. What a task throws is logged if it was executed
   * without a {@link java.util.concurrent.Future} that keeps it.
   *
   * @param name of the threads, which have a number besides
   * @param kept how long a thread waits for its next task
   */
  public ExecutorService pool(String name, Duration kept) {
    AtomicInteger made = new AtomicInteger();
    return new ThreadPoolExecutor(
        0,
        Integer.MAX_VALUE,
        kept.toMillis(),
        TimeUnit.MILLISECONDS,
        new SynchronousQueue<>(),
        body -> platform(name + made.getAndIncrement(), body));
  }

  /**
   * One thread for one task after the other, as long as there are any. What a task throws is logged
   * if it was executed without a {@link java.util.concurrent.Future} that keeps it.
   *
   * @param kept how long the thread waits for its next task
   */
  public ExecutorService inTurn(String name, Duration kept) {
    ThreadPoolExecutor made =
        new ThreadPoolExecutor(
            1,
            1,
            kept.toMillis(),
            TimeUnit.MILLISECONDS,
            new LinkedBlockingQueue<>(),
            body -> platform(name, body));
    made.allowCoreThreadTimeOut(true);
    return made;
  }

  /**
   * One thread for one task after the other. What a task throws is logged if it was executed
   * without a {@link java.util.concurrent.Future} that keeps it.
   *
   * @param stackBytes the size of its stack
   */
  public ExecutorService single(String name, long stackBytes) {
    return Executors.newSingleThreadExecutor(
        body -> platform(name, stackBytes, body, failure -> {}));
  }

  /** One thread for tasks that have their time; a periodic one goes on whatever it has thrown. */
  public ScheduledThreadPoolExecutor clock(String name) {
    return new Schedule(name);
  }

  private static String where(String thread) {
    return "the thread " + thread;
  }

  /** The tasks are guarded here: the JDK keeps what they throw, and nobody asks for that. */
  private final class Schedule extends ScheduledThreadPoolExecutor {
    private final String where;

    Schedule(String name) {
      super(1, body -> platform(name, body));
      where = where(name);
    }

    @Override
    public ScheduledFuture<?> schedule(Runnable task, long delay, TimeUnit unit) {
      return super.schedule(guarding(where, task), delay, unit);
    }

    @Override
    public ScheduledFuture<?> scheduleAtFixedRate(
        Runnable task, long delay, long period, TimeUnit unit) {
      return super.scheduleAtFixedRate(guarding(where, task), delay, period, unit);
    }

    @Override
    public ScheduledFuture<?> scheduleWithFixedDelay(
        Runnable task, long delay, long pause, TimeUnit unit) {
      return super.scheduleWithFixedDelay(guarding(where, task), delay, pause, unit);
    }
  }
}
