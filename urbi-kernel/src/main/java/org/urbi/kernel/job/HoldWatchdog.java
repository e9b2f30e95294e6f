package org.urbi.kernel.job;

import java.util.function.BiConsumer;
import org.urbi.kernel.time.Clock;

/**
 * Watches from another thread whether a job holds the kernel for too long without letting others
 * run, and ends that job. If the job waits inside the Java code of a component, that thread is
 * interrupted, too.
 */
public final class HoldWatchdog {
  /** How many times the watchdog checks within the time limit. */
  private static final int LOOKS = 20;

  private static final long LONGEST_PAUSE = 50;

  private final Scheduler scheduler;
  private final Clock machine;
  private final long limit;
  private final long pause;
  private final BiConsumer<Job, String> listener;
  private volatile long heldTurn = -1;
  private volatile long heldSince;

  /** Whether the job of this turn was ended; for its own thread alone. */
  private boolean told;

  /**
   * @param limit in nanoseconds
   * @param listener called with the job and the component function that it executes, or null
   */
  HoldWatchdog(Scheduler scheduler, Clock machine, long limit, BiConsumer<Job, String> listener) {
    this.scheduler = scheduler;
    this.machine = machine;
    this.limit = limit;
    this.pause = Math.clamp(limit / LOOKS / 1_000_000, 1, LONGEST_PAUSE);
    this.listener = listener;
  }

  void start() {
    Thread.ofPlatform().daemon().name("urbi-watch").start(this::watch);
  }

  /**
   * For how long a job has held the kernel, in nanoseconds; 0 if none does. May be asked on any
   * thread.
   */
  public long heldFor() {
    long since = heldSince;
    return heldTurn == scheduler.turn() && scheduler.running() != null ? machine.now() - since : 0;
  }

  /** Interrupts what holds the kernel, as its client could; from any thread. */
  public void interrupt() {
    end(scheduler.turn());
  }

  private void watch() {
    while (!scheduler.isOver()) {
      check();
      try {
        Thread.sleep(pause);
      } catch (InterruptedException e) {
        return;
      }
    }
  }

  /** Checks whether the same turn is still running, and for how long. */
  void check() {
    long seen = scheduler.turn();
    long now = machine.now();
    if (seen != heldTurn || scheduler.running() == null) {
      heldSince = now;
      heldTurn = seen;
      told = false;
    } else if (!told && now - heldSince >= limit) {
      told = true;
      end(seen);
    }
  }

  private void end(long turn) {
    Job job = scheduler.running();
    if (job != null) {
      String component = job.component();
      scheduler.interruptions().requestOverdue(turn);
      listener.accept(job, component);
      if (component != null) {
        job.interruptComponent(turn);
      }
    }
  }
}
