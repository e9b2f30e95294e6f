package urbi.remote;

import java.util.ArrayDeque;
import java.util.function.Consumer;

/**
 * Reads, and runs what comes, one after the other, on whichever of a few threads has it in hand:
 * the thread that has read a call executes it at once, while another goes on reading. So a call
 * costs no change of threads, and a call that takes long keeps nobody from reading.
 */
final class Dispatcher {
  /** Reads one frame: executes it, or hands it to {@link Dispatcher#run}. */
  interface Reading {
    /** False at the end. */
    boolean next();
  }

  private final Reading reading;
  private final Consumer<Runnable> guard;
  private final ArrayDeque<Runnable> tasks = new ArrayDeque<>();
  private final Object readers = new Object();
  private boolean executing;
  private boolean somebodyReads;
  private int idle;
  private boolean ended;
  private volatile Thread executor;

  /**
   * @param guard executes a task, and never throws
   */
  Dispatcher(Reading reading, Consumer<Runnable> guard) {
    this.reading = reading;
    this.guard = guard;
  }

  void start() {
    somebodyReads = true;
    newThread(true);
  }

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

  /**
   * Reads until a task had to be executed, in which case somebody else reads now; or to the end.
   */
  private void read() {
    while (true) {
      if (!reading.next()) {
        synchronized (readers) {
          ended = true;
          somebodyReads = false;
          readers.notifyAll();
        }
        return;
      }
      if (mayExecute()) {
        boolean another;
        synchronized (readers) {
          somebodyReads = false;
          another = idle == 0;
          readers.notify();
        }
        if (another) {
          newThread(false);
        }
        execute();
        return;
      }
    }
  }

  private boolean mayExecute() {
    synchronized (tasks) {
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
      synchronized (tasks) {
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
    synchronized (tasks) {
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
