package urbi.remote;

import java.util.ArrayDeque;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import urbi.thread.GuardedThreads;
import urbi.time.Stopwatch;

/**
 * Reads frames, and executes tasks one after the other on one thread, which never changes. While it
 * has no task, that thread also reads frames, so a call needs no thread switch. While a task takes
 * long or waits for an answer, a helper thread reads.
 */
final class Dispatcher {
  /** How long a task takes at least that the helper reads meanwhile, in nanoseconds. */
  private static final long LONG_NANOSECONDS = 5_000_000;

  /** Reads one frame: executes it, or hands it to {@link Dispatcher#run}. */
  interface FrameReader {
    /** False at the end. */
    boolean next();
  }

  private final FrameReader reading;
  private final Consumer<Runnable> guard;
  private final Runnable wake;

  private final Object lock = new Object();
  private final ArrayDeque<Runnable> tasks = new ArrayDeque<>();

  /** Held while a task is executed, or by who wants none to be. Fair: many tasks starve nobody. */
  private final ReentrantLock turn = new ReentrantLock(true);

  /** What the thread that executes does now. */
  private enum State {
    EXECUTES,
    READS,
    WAITS
  }

  private State state = State.EXECUTES;
  private boolean helperReads;
  private boolean neverReads;
  private boolean woken;
  private boolean ended;

  private final Thread executor;
  private final Thread helper;
  private final Thread watch;
  private volatile long begun; // written by the executor alone
  private volatile boolean watchSleeps;

  /**
   * @param guard executes a task, and never throws
   * @param wake has something sent soon that can be read
   * @param onFailure is told when one of the threads ends because of a defect
   */
  Dispatcher(
      FrameReader reading, Consumer<Runnable> guard, Runnable wake, Consumer<Throwable> onFailure) {
    this.reading = reading;
    this.guard = guard;
    this.wake = wake;
    GuardedThreads threads = GuardedThreads.SDK;
    this.executor = threads.platform("urbi-remote", this::work, onFailure);
    this.helper = threads.platform("urbi-remote-reader", this::help, onFailure);
    this.watch = threads.platform("urbi-remote-watch", this::watch, onFailure);
  }

  void start() {
    executor.start();
    helper.start();
    watch.start();
  }

  private void await() {
    try {
      lock.wait();
    } catch (InterruptedException e) {
      // Code that was called on this thread: that is over.
    }
  }

  // ------------------------------------------------------------------ who executes

  private void work() {
    while (true) {
      Runnable task = next();
      if (task != null) {
        countTask();
        turn.lock();
        try {
          guard.accept(task);
        } finally {
          turn.unlock();
        }
      } else if (!hasEnded()) {
        boolean more = reading.next();
        synchronized (lock) {
          state = State.EXECUTES;
          if (!more) {
            end();
          }
        }
      } else {
        return;
      }
    }
  }

  /** The watch looks at how long each task takes. */
  private void countTask() {
    begun++;
    if (watchSleeps) {
      LockSupport.unpark(watch);
    }
  }

  /** The next task; null when this thread is to read, or when all has ended. */
  private @Nullable Runnable next() {
    synchronized (lock) {
      while (true) {
        Runnable task = tasks.poll();
        if (task != null) {
          state = State.EXECUTES;
          return task;
        }
        if (ended) {
          return null;
        }
        if (neverReads && !helperReads) {
          helperReads = true;
          lock.notifyAll();
        }
        if (!helperReads) {
          state = State.READS;
          woken = false;
          return null;
        }
        state = State.WAITS;
        await();
      }
    }
  }

  private boolean hasEnded() {
    synchronized (lock) {
      return ended;
    }
  }

  private void end() {
    ended = true;
    lock.notifyAll();
    LockSupport.unpark(watch);
  }

  /** Has something executed in turn. */
  void run(Runnable task) {
    boolean asleep;
    synchronized (lock) {
      tasks.add(task);
      if (state == State.WAITS) {
        lock.notifyAll();
      }
      asleep = state == State.READS && !woken && Thread.currentThread() != executor;
      woken |= asleep;
    }
    if (asleep) {
      wake.run();
    }
  }

  /**
   * From now on tasks come from elsewhere than the connection, and do not wait until something can
   * be read.
   */
  void expectTasks() {
    boolean asleep;
    synchronized (lock) {
      asleep = !neverReads && state == State.READS && Thread.currentThread() != executor;
      neverReads = true;
    }
    if (asleep) {
      wake.run();
    }
  }

  /** Whether this thread executes a task, or keeps others from being executed. */
  boolean isExecuting() {
    return Thread.currentThread() == executor || turn.isHeldByCurrentThread();
  }

  /** Waits for its turn, and keeps it: no task is executed until {@link #release}. */
  void hold() {
    if (Thread.currentThread() == executor) {
      return;
    }
    try {
      turn.lockInterruptibly();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException("interrupted while waiting for the turn");
    }
  }

  /** Ends {@link #hold}; of no effect without it. */
  void release() {
    if (Thread.currentThread() != executor && turn.isHeldByCurrentThread()) {
      turn.unlock();
    }
  }

  /**
   * Waits so long; on the thread that executes tasks, in the middle of one, others are executed
   * meanwhile.
   */
  void letOthersRun(long nanoseconds) throws InterruptedException {
    if (Thread.currentThread() != executor) {
      TimeUnit.NANOSECONDS.sleep(nanoseconds);
      return;
    }
    long deadline = Stopwatch.nanoseconds() + nanoseconds;
    do {
      Runnable task = nextUntil(deadline);
      if (task != null) {
        countTask();
        guard.accept(task);
      }
    } while (Stopwatch.nanoseconds() - deadline < 0);
  }

  /** The next task; null if none comes in time. The helper reads meanwhile. */
  private @Nullable Runnable nextUntil(long deadline) throws InterruptedException {
    synchronized (lock) {
      try {
        while (tasks.isEmpty()) {
          if (!helperReads && !ended) {
            helperReads = true;
            lock.notifyAll();
          }
          long left = deadline - Stopwatch.nanoseconds();
          if (left <= 0) {
            return null;
          }
          state = State.WAITS;
          TimeUnit.NANOSECONDS.timedWait(lock, left);
        }
        return tasks.poll();
      } finally {
        state = State.EXECUTES;
      }
    }
  }

  // ------------------------------------------------------------------ the helper

  private void help() {
    while (true) {
      synchronized (lock) {
        while (!helperReads && !ended) {
          await();
        }
        if (ended) {
          return;
        }
      }
      boolean more = reading.next();
      synchronized (lock) {
        if (!more) {
          end();
        } else if (state == State.WAITS) {
          helperReads = neverReads;
          if (!helperReads) {
            lock.notifyAll();
          }
        }
      }
    }
  }

  /** Has the helper read when the thread that should executes something for long. */
  private void watch() {
    long last = 0;
    while (true) {
      long now = begun;
      if (now == last && !callHelper(now)) {
        watchSleeps = true;
        while (begun == now) {
          if (hasEnded()) {
            return;
          }
          LockSupport.park(this);
        }
        watchSleeps = false;
      }
      last = begun;
      LockSupport.parkNanos(this, LONG_NANOSECONDS);
    }
  }

  /** Has the helper read, if that task is still executed and nobody reads. */
  private boolean callHelper(long task) {
    synchronized (lock) {
      if (begun != task || state != State.EXECUTES || helperReads || ended) {
        return false;
      }
      helperReads = true;
      lock.notifyAll();
      return true;
    }
  }

  /** What this thread executes is about to wait for something that has to be read. */
  void letRead() {
    if (isExecuting()) {
      callHelper(begun);
    }
  }
}
