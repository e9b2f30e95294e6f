package urbi.remote;

import java.util.ArrayDeque;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * Reads, and runs what comes, one after the other, on whichever of a few threads has it in hand.
 * The thread that has read a call executes it at once, so that a call costs no change of threads;
 * when that takes long, or asks for something that has to be read, another thread goes on reading.
 */
final class Dispatcher {
  /** How long a task takes at least that another thread reads for, in nanoseconds. */
  private static final long LONG_NANOSECONDS = 5_000_000;

  /** Reads one frame: executes it, or hands it to {@link Dispatcher#run}. */
  interface Reading {
    /** False at the end. */
    boolean next();
  }

  private final Reading reading;
  private final Consumer<Runnable> guard;

  private final Object tasksLock = new Object();
  private final ArrayDeque<Runnable> tasks = new ArrayDeque<>();
  private boolean executing;
  private volatile Thread executor;

  private final Object readers = new Object();
  private Thread reader;
  private boolean readerExecutes;
  private boolean somebodyReads = true;
  private int idle;
  private boolean ended;

  private final Thread watch;
  private volatile long begun;
  private volatile boolean watchSleeps;

  /**
   * @param guard executes a task, and never throws
   */
  Dispatcher(Reading reading, Consumer<Runnable> guard) {
    this.reading = reading;
    this.guard = guard;
    this.watch = Thread.ofPlatform().daemon().name("urbi-remote-watch").unstarted(this::watch);
  }

  void start() {
    newThread(true);
    watch.start();
  }

  // ------------------------------------------------------------------ who reads

  private void newThread(boolean reads) {
    Thread.ofPlatform()
        .daemon()
        .name("urbi-remote")
        .start(() -> {
          if (reads) {
            read();
          }
          while (awaitTurn()) {
            read();
          }
        });
  }

  private boolean awaitTurn() {
    synchronized (readers) {
      idle++;
      while (somebodyReads && !ended) {
        try {
          readers.wait();
        } catch (InterruptedException e) {
          // Code that was called on this thread: that is over.
        }
      }
      idle--;
      somebodyReads = true;
      return !ended;
    }
  }

  /** Reads, and executes what it has read, until somebody else reads instead; or to the end. */
  private void read() {
    Thread self = Thread.currentThread();
    synchronized (readers) {
      reader = self;
    }
    while (true) {
      if (!reading.next()) {
        end();
        return;
      }
      if (mayExecute()) {
        synchronized (readers) {
          readerExecutes = true;
          begun++;
        }
        if (watchSleeps) {
          LockSupport.unpark(watch);
        }
        execute();
        synchronized (readers) {
          if (reader != self) {
            return;
          }
          readerExecutes = false;
        }
      }
    }
  }

  private void end() {
    synchronized (readers) {
      ended = true;
      readers.notifyAll();
    }
    LockSupport.unpark(watch);
  }

  /** Has another thread read when the one that should executes something for long. */
  private void watch() {
    long last = 0;
    while (true) {
      long now = begun;
      if (now == last && !promote(now)) {
        watchSleeps = true;
        while (begun == now) {
          synchronized (readers) {
            if (ended) {
              return;
            }
          }
          LockSupport.park(this);
        }
        watchSleeps = false;
      }
      last = begun;
      LockSupport.parkNanos(this, LONG_NANOSECONDS);
    }
  }

  /** Has another thread read, if the one that should still executes that task. */
  private boolean promote(long task) {
    boolean another;
    synchronized (readers) {
      if (begun != task || !readerExecutes || ended) {
        return false;
      }
      reader = null;
      readerExecutes = false;
      somebodyReads = false;
      another = idle == 0;
      readers.notify();
    }
    if (another) {
      newThread(false);
    }
    return true;
  }

  /** What this thread executes is about to wait for something that has to be read. */
  void letRead() {
    boolean reads;
    synchronized (readers) {
      reads = reader == Thread.currentThread();
    }
    if (reads) {
      promote(begun);
    }
  }

  // ------------------------------------------------------------------ who executes

  private boolean mayExecute() {
    synchronized (tasksLock) {
      if (executing || tasks.isEmpty()) {
        return false;
      }
      executing = true;
      return true;
    }
  }

  private void execute() {
    executor = Thread.currentThread();
    while (true) {
      Runnable task;
      synchronized (tasksLock) {
        task = tasks.poll();
        if (task == null) {
          executor = null;
          executing = false;
          return;
        }
      }
      guard.accept(task);
    }
  }

  /** Has something executed in turn; by the reading, when it has read a call. */
  void run(Runnable task) {
    synchronized (tasksLock) {
      tasks.add(task);
    }
  }

  /** Has something executed in turn, by the thread that asks if it is nobody's turn. */
  void runHere(Runnable task) {
    run(task);
    if (mayExecute()) {
      execute();
    }
  }

  /** Whether this thread executes a task. */
  boolean isExecuting() {
    return Thread.currentThread() == executor;
  }
}
