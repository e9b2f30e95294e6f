package org.urbi.kernel.outside;

import java.io.Closeable;
import java.io.InterruptedIOException;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;

/**
 * A program that is being started, on a thread of its own. If nobody waits for that any more, or
 * the kernel ends meanwhile, the program is killed as soon as it is there: it would go on without
 * anybody who knows of it.
 */
final class ProgramStart implements Callable<Process>, Closeable {
  /** For how long the end of a kernel waits for a program that is just being started. */
  private static final int LOOKS = 20;

  private static final long BETWEEN_LOOKS_MILLISECONDS = 100;

  private final Outside outside;
  private final Callable<Process> starting;

  /** Guarded by this object, as all that follows. */
  private @Nullable Process process;

  private boolean running;
  private boolean unwanted;

  private ProgramStart(Outside outside, Callable<Process> starting) {
    this.outside = outside;
    this.starting = starting;
  }

  /** The kernel knows of it until it {@linkplain #over is over}. */
  static ProgramStart of(Outside outside, Callable<Process> starting) {
    ProgramStart made = new ProgramStart(outside, starting);
    outside.opened(made);
    return made;
  }

  /** Starts the program. */
  @Override
  public Process call() throws Exception {
    begin();
    Process made = null;
    try {
      made = starting.call();
      return made;
    } finally {
      if (end(made) || made == null) {
        drop(made);
      }
    }
  }

  private synchronized void begin() throws InterruptedIOException {
    if (unwanted) {
      throw new InterruptedIOException();
    }
    running = true;
  }

  /** Whether nobody wants the program. */
  private synchronized boolean end(@Nullable Process made) {
    process = made;
    running = false;
    notifyAll();
    return unwanted;
  }

  private void drop(@Nullable Process made) {
    if (made != null) {
      ChildProcess.end(made);
    }
    over();
  }

  /** The program has been started, and somebody has it now. */
  void over() {
    outside.closed(this);
  }

  /** Nobody waits for the program any more. */
  void abandon() {
    Process made;
    synchronized (this) {
      unwanted = true;
      if (running) {
        return;
      }
      made = process;
    }
    drop(made);
  }

  /** The kernel ends: the program is not to outlive it. */
  @Override
  public void close() {
    Process made;
    synchronized (this) {
      unwanted = true;
      try {
        for (int i = 0; running && i < LOOKS; i++) {
          wait(BETWEEN_LOOKS_MILLISECONDS);
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      made = process;
    }
    if (made != null) {
      ChildProcess.end(made);
    }
  }
}
