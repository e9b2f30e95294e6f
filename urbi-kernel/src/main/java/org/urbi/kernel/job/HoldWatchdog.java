package org.urbi.kernel.job;

import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.journal.StopReason;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.log.WatchFailure;
import org.urbi.kernel.time.Clock;

/**
 * Watches from another thread whether a job holds the kernel for too long without letting others
 * run, or allocates more memory meanwhile than its budget allows, and ends that job. Both are
 * measured by {@link HoldMeter}, too, which code that only waits for Java never asks. If the job
 * waits inside the Java code of a component, that thread is interrupted, too.
 *
 * <p>Code that gets no processor holds nothing: once half of the limit has passed, only the
 * processor time of the kernel thread counts. A component may wait instead of work, so for it the
 * machine's clock counts throughout.
 *
 * <p>While memory is nearly exhausted, whoever holds the kernel keeps others from giving theirs
 * back, so code may then work for a small part of that time only.
 */
public final class HoldWatchdog {
  /** A processor time that nobody knows. */
  static final long UNKNOWN = -1;

  /** How many times the watchdog checks within the time limit. */
  private static final int LOOKS = 20;

  /** How long it sleeps between two checks, in nanoseconds. */
  private static final long LONGEST_PAUSE = 50_000_000;

  private static final long SHORTEST_PAUSE = 250_000;

  /** How long it sleeps where memory is limited, which megabytes can fill in a millisecond. */
  private static final long MEMORY_PAUSE = 500_000;

  /** The part of the limit that is left while memory is nearly exhausted. */
  private static final int HURRY = 20;

  /** The part of all memory that a turn may allocate while that is nearly exhausted. */
  private static final int HURRIED_PART = 32;

  /** So many turns fit in the memory that is free. */
  private static final int TURNS_IN_FREE_MEMORY = 64;

  /** What neither works nor lets others run is ended as well, after so many times the limit. */
  private static final int LONGEST_WAIT = 20;

  private final Scheduler scheduler;
  private final Clock machine;
  private final Gauges gauges;
  private final long limit;
  private volatile long pause;
  private final Listener listener;
  private final HoldMeter meter;
  private volatile boolean hurried;
  private volatile boolean memoryLimited;
  private volatile long heldTurn = -1;
  private volatile long heldSince;
  private @Nullable Thread thread;

  /** The turn whose job was ended last. */
  private volatile long toldTurn = -1;

  // These are for its own thread alone.

  /**
   * Whether the component that it was executing then, or began to execute since, was interrupted.
   */
  private boolean interrupted;

  private final WatchFailure failure = new WatchFailure("the watch for jobs that hold the kernel");

  /** The processor time of the kernel thread when half of the limit was over. */
  private long processorTimeAtHalf = UNKNOWN;

  /** What of the limit was over then. */
  private long heldAtHalf;

  /** What the kernel thread had allocated when this turn was first seen. */
  private long allocatedBefore;

  /**
   * What is measured of the kernel.
   *
   * @param processorTime how much its thread has had, in nanoseconds, or {@link #UNKNOWN}
   * @param allocated how many bytes its thread has allocated
   * @param free how many bytes of memory are free
   * @param memory how many bytes of memory there are
   */
  public record Gauges(
      LongSupplier processorTime, LongSupplier allocated, LongSupplier free, long memory) {}

  /** Who is told when a job is ended. */
  @FunctionalInterface
  public interface Listener {
    /**
     * Called on the watchdog's thread or the kernel thread.
     *
     * @param component the component function that it executes, or null
     * @param limit how long it was allowed to hold the kernel, in nanoseconds; for {@link
     *     StopReason#GREEDY} how much it was allowed to allocate, in bytes
     */
    void ended(Job job, @Nullable String component, StopReason why, long limit);
  }

  /**
   * @param limit in nanoseconds; {@link Long#MAX_VALUE} for none but those of budgets
   */
  HoldWatchdog(Scheduler scheduler, Clock machine, Gauges gauges, long limit, Listener listener) {
    this.scheduler = scheduler;
    this.machine = machine;
    this.gauges = gauges;
    this.limit = limit;
    this.pause = pauseFor(limit);
    this.listener = listener;
    this.meter = new HoldMeter(gauges.allocated, this, scheduler.memory().gate());
  }

  /**
   * Ends jobs that hold the kernel for longer without letting others run; once, when the kernel has
   * been started.
   *
   * @param limit in nanoseconds; {@link Long#MAX_VALUE} for none
   * @param freeMemory how many bytes of memory are free
   * @param memory how many bytes of memory there are
   * @param told called on another thread when that has happened
   */
  public static HoldWatchdog watch(
      Scheduler scheduler, long limit, LongSupplier freeMemory, long memory, Listener told) {
    JobThread.Factory threads = scheduler.threads();
    var gauges = new Gauges(threads::processorTime, threads::allocatedBytes, freeMemory, memory);
    var watchdog = new HoldWatchdog(scheduler, scheduler.machine(), gauges, limit, told);
    watchdog.start();
    return watchdog;
  }

  private static long pauseFor(long limit) {
    return Math.clamp(limit / LOOKS, SHORTEST_PAUSE, LONGEST_PAUSE);
  }

  /** Starts to watch, if there is a limit. */
  void start() {
    if (limit != Long.MAX_VALUE) {
      watchHolds();
    }
  }

  /** The budget of a lobby has a limit, in nanoseconds, which must be watched from now on. */
  public synchronized void watchBudget(long budgeted) {
    pause = Math.min(pause, pauseFor(budgeted));
    watchHolds();
  }

  /** The budget of a lobby limits what a job may allocate at one go. */
  public synchronized void watchMemory() {
    limitMemory();
    watchHolds();
  }

  /** From now on it looks how much is allocated, and so does the kernel thread. */
  synchronized void limitMemory() {
    memoryLimited = true;
    pause = Math.min(pause, MEMORY_PAUSE);
    scheduler.interruptions().measure(meter);
  }

  /**
   * On the kernel thread: the running job, whose turn has that number, has reached a limit; told
   * once.
   */
  void endOnce(Job job, long turn, StopReason why, long limit) {
    if (toldTurn != turn) {
      end(job, turn, why, limit);
    }
  }

  /**
   * From now on {@link #heldFor} is known, and memory limited while it is nearly exhausted,
   * although the kernel may be held as long as anybody likes.
   */
  public synchronized void watchHolds() {
    if (thread == null) {
      thread = FailureLog.THREADS.platform("urbi-watch", this::watch);
      thread.start();
    }
  }

  /** The kernel has ended: its watch need not keep it in memory until the next look. */
  public synchronized void end() {
    LockSupport.unpark(thread);
  }

  /**
   * For how long a job has held the kernel, in nanoseconds; 0 if none does. May be asked on any
   * thread.
   */
  public long heldFor() {
    long since = heldSince;
    return heldTurn == scheduler.turn() && scheduler.running() != null ? machine.now() - since : 0;
  }

  /**
   * Says whether memory is nearly exhausted; from any thread. What is left of it is for those who
   * give back theirs: as long as that lasts, nobody may allocate much without letting them run.
   */
  public void hurry(boolean is) {
    hurried = is;
    if (is) {
      measureTurn(scheduler.turn());
    } else {
      endMeasuring();
    }
  }

  private synchronized void measureTurn(long turn) {
    scheduler.interruptions().measure(meter);
    scheduler.interruptions().measureTurn(turn);
  }

  /** What was measured because it lasted is over: that is no reason to ask in each turn to come. */
  private synchronized void endMeasuring() {
    if (!memoryLimited && !hurried && scheduler.interruptions().isMeasuring()) {
      scheduler.interruptions().measureNothing();
    }
  }

  /** Whether memory is nearly exhausted. */
  boolean isHurried() {
    return hurried;
  }

  /** Interrupts what holds the kernel, as its client could; from any thread. */
  public void interrupt() {
    long turn = scheduler.turn();
    Job job = scheduler.running();
    if (job != null && turn == scheduler.turn()) {
      end(job, turn, StopReason.OVERDUE, heldFor());
    }
  }

  private void watch() {
    while (!scheduler.isOver()) {
      try {
        check();
      } catch (RuntimeException | Error e) {
        // Without this thread no job would end any more.
        failure.met(e);
      }
      LockSupport.parkNanos(hurried ? Math.max(SHORTEST_PAUSE, pause / HURRY) : pause);
      if (Thread.interrupted()) {
        return;
      }
    }
  }

  /** Checks whether the same turn is still running, and for how long. */
  void check() {
    long seen = scheduler.turn();
    long now = machine.now();
    Job job = scheduler.running();
    if (seen != heldTurn || job == null || seen != scheduler.turn()) {
      heldSince = now;
      heldTurn = seen;
      interrupted = false;
      processorTimeAtHalf = UNKNOWN;
      if (memoryLimited) {
        allocatedBefore = gauges.allocated.getAsLong();
      }
      endMeasuring();
    } else if (toldTurn != seen) {
      if (gauges.free.getAsLong() < gauges.memory / 2) {
        measureTurn(seen);
      }
      long memory = memoryLimited ? memoryFor(job) : Budget.UNLIMITED;
      if (memory != Budget.UNLIMITED && gauges.allocated.getAsLong() - allocatedBefore > memory) {
        end(job, seen, StopReason.GREEDY, memory);
        return;
      }
      long allowed = holdFor(job);
      if (isOverdue(job, now - heldSince, allowed)) {
        end(job, seen, StopReason.OVERDUE, allowed);
      }
    } else if (!interrupted) {
      interruptComponent(job, seen);
    }
  }

  /** For how long a job may hold the kernel, in nanoseconds. */
  long holdFor(Job job) {
    long most = job.budget().holdLimit(limit);
    return hurried ? Math.min(most, limit / HURRY) : most;
  }

  /** The time of the machine, in nanoseconds. */
  long time() {
    return machine.now();
  }

  /** The processor time of the kernel thread, in nanoseconds; unless it is {@link #UNKNOWN}. */
  long processorTime() {
    return gauges.processorTime.getAsLong();
  }

  /** What the turn of a job may allocate: in a crowd there must be something left for others. */
  long memoryFor(Job job) {
    long most = job.budget().limit(Resource.MEMORY);
    return most == Budget.UNLIMITED
        ? mostFor(job)
        : Math.min(most, gauges.free.getAsLong() / TURNS_IN_FREE_MEMORY);
  }

  /** What the turn of a job may allocate, however much is free. */
  long mostFor(Job job) {
    long most = job.budget().limit(Resource.MEMORY);
    return hurried ? Math.min(most, gauges.memory / HURRIED_PART) : most;
  }

  private boolean isOverdue(Job job, long held, long allowed) {
    if (held >= allowed / 2 && processorTimeAtHalf == UNKNOWN) {
      // Asking for it earlier would cost the start of every kernel some milliseconds.
      processorTimeAtHalf = gauges.processorTime.getAsLong();
      // This thread may be late, too, as when garbage is collected.
      heldAtHalf = Math.min(held, allowed / 4 * 3);
    }
    if (held < allowed) {
      return false;
    }
    long most = job.budget().holdLimit(limit);
    if (job.component() != null || processorTimeAtHalf == UNKNOWN) {
      return held >= most;
    }
    return heldAtHalf + gauges.processorTime.getAsLong() - processorTimeAtHalf >= allowed
        || held / LONGEST_WAIT >= most;
  }

  /** Ends the turn of that number, which is that job's. */
  private void end(Job job, long turn, StopReason why, long allowed) {
    toldTurn = turn;
    String component = job.component();
    scheduler.interruptions().requestOverdue(turn, why);
    interruptComponent(job, turn);
    listener.ended(job, component, why, allowed);
  }

  /**
   * What waits in Java code takes no notice of requests; it may have been called after one, too.
   */
  private void interruptComponent(Job job, long turn) {
    if (job.component() != null) {
      interrupted = true;
      job.interruptComponent(turn);
    }
  }
}
