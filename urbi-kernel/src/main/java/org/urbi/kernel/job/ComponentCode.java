package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;

/**
 * The Java code of components that one job executes. It runs on the thread of the job, where only
 * an interrupt of that thread can end what it waits for.
 */
public final class ComponentCode {
  private final Job job;
  private final JobThread thread;
  private @Nullable String function;
  private boolean interrupted;

  ComponentCode(Job job, JobThread thread) {
    this.job = job;
    this.thread = thread;
  }

  /** The component function that is being executed, or null. May be called on any thread. */
  public @Nullable String function() {
    return function;
  }

  /** Java code of a component begins to run, in the given function, until {@link #leave}. */
  public @Nullable String enter(@Nullable String entered) {
    String outer = function;
    function = entered;
    return outer;
  }

  /**
   * Java code of a component has returned, or has thrown something.
   *
   * @param outer what {@link #enter} has returned
   */
  public void leave(@Nullable String outer) {
    if (outer != null || !job.scheduler().interruptions().arePending()) {
      function = outer;
      return;
    }
    takeInterruption();
    try {
      job.checkInterrupted();
    } finally {
      function = null;
    }
  }

  private synchronized void takeInterruption() {
    if (interrupted) {
      interrupted = false;
      Thread.interrupted();
    }
  }

  /** Interrupts code that waits, if that turn still lasts; called from another thread. */
  synchronized void interrupt(long turn) {
    if (function != null && job.scheduler().turn() == turn) {
      interrupted = true;
      thread.interrupt();
    }
  }
}
