package org.urbi.kernel.job;

import java.util.function.BooleanSupplier;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.time.Clock;

/**
 * The time of the tick loop: that of the present tick, the number of the tick, and how simulated
 * time moves on. On the kernel thread.
 */
public final class TickTime {
  /** After so many cycles in a row in which jobs were runnable simulated time moves on. */
  private static final int BUSY_CYCLES = 1000;

  /**
   * By how much simulated time moves on then: a microsecond for each of these cycles. Otherwise a
   * job that never waits would keep sleeping jobs asleep for ever.
   */
  private static final long BUSY_STEP = 1000L * BUSY_CYCLES;

  /** From when on a tick has taken long, in nanoseconds. */
  private static final long LONG_TICK = 10_000_000;

  private final Clock clock;
  private final Journal journal;
  private final Timers timers;
  private final YieldCount yields;
  private final SimulationPace pace;
  private final boolean counted;
  private final CycleStatistics statistics = new CycleStatistics();
  private Runnable whenQuiet = () -> {};
  private long read;
  private long now;
  private long before;
  private long cycle;
  private boolean begins;
  private int holders;
  private long busyUntil = 1 + BUSY_CYCLES;

  TickTime(Clock clock, Journal journal, Timers timers, YieldCount yields, SimulationPace pace) {
    this.clock = clock;
    this.journal = journal;
    this.timers = timers;
    this.yields = yields;
    this.pace = pace;
    this.counted = journal.countsChecks();
  }

  /** The time of this tick, in nanoseconds since the kernel was started. */
  long now() {
    return now;
  }

  /**
   * The number of ticks so far, including those that were skipped because only one job could run.
   */
  public long cycle() {
    return cycle + yields.passed();
  }

  /** How long ticks take. */
  public CycleStatistics statistics() {
    return statistics;
  }

  /** The current time, which may be later than that of the tick; for measurements. */
  long measure() {
    if (!counted) {
      return clock.now();
    }
    return journal.ask(clock::now);
  }

  /**
   * Tries to start an activity outside, and returns whether it could. In a replay nothing is
   * started, and the recorded result is returned.
   */
  public boolean attempt(BooleanSupplier beginning) {
    return journal.ask(beginning::getAsBoolean);
  }

  /** Whether somebody's time has come, in real time, while the running job goes on. */
  public boolean isTimerDue() {
    return clock.isReal() && timers.next() <= clock.now();
  }

  /** When a wait ends that begins now and lasts so many nanoseconds. */
  long deadline(long wait) {
    long time = clock.isReal() ? measure() : now;
    return (time - now < LONG_TICK ? now : time) + wait;
  }

  /** Holds simulated time, because more input is expected for the present moment. */
  public void hold() {
    holders++;
  }

  /** Ends one {@link #hold}. */
  public void release() {
    holders--;
  }

  /** A tick begins: reads the clock. */
  void beginTick() {
    // Input that was awaited while time was held could as well have arrived in the cycle before, so
    // it does not start a new count.
    begins = clock.isReal() || holders == 0;
    if (begins) {
      cycle++;
    }
    before = now;
    read = clock.now();
    now = Math.max(now, journal.tick(Math.max(now, read)));
  }

  /** What the clock said when this tick began: not the time of the tick in a replay. */
  long read() {
    return read;
  }

  /** Runs what is due; where others wait meanwhile, as much as a tick has time for. */
  void fireTimers() {
    if (clock.isReal()) {
      timers.fireSome(now);
    } else {
      timers.fire(now);
    }
  }

  /** There was nobody to run in this tick. */
  void endEmptyTick() {
    if (begins && !clock.isReal() && timers.next() == Long.MAX_VALUE) {
      cycle--;
    } else {
      countTick();
    }
    // Counted from the cycle that may find something first.
    busyUntil = cycle() + (holders == 0 ? 1 : 0) + BUSY_CYCLES;
  }

  /** There is somebody to run in this tick. */
  void countTick() {
    if (begins) {
      statistics.add(now - before);
    }
  }

  /** All have had their turn in this tick. */
  void endTick() {
    if (holders > 0) {
      busyUntil = cycle() + BUSY_CYCLES;
    } else if (isBusyForLong()) {
      busyUntil = cycle() + BUSY_CYCLES;
      clock.advanceTo(now + BUSY_STEP);
    }
  }

  /** Whether simulated time must move on although jobs have been runnable all the time. */
  boolean isBusyForLong() {
    return cycle() >= busyUntil && !clock.isReal();
  }

  /** How many {@code ;} may pass in a row without a look at anything but news. */
  long grant() {
    return counted ? 0 : clock.isReal() ? Long.MAX_VALUE : busyUntil - cycle() - 1;
  }

  /**
   * Nobody can run, but timers may be due. Only where nobody counts, a tick may be left out.
   *
   * @param pending whether there is something to do at the end of a tick
   */
  boolean isTickDue(boolean pending) {
    if (counted || !clock.isReal()) {
      return true;
    }
    long time = clock.now();
    boolean due = yields.look(time) || time >= timers.next() || pending;
    yields.reset();
    now = Math.max(now, time);
    return due;
  }

  /**
   * Sets an action that runs whenever the kernel is quiet: there is nothing to run, no deadline,
   * and no activity outside that the kernel has started, so that only a message could bring more.
   * To be called before the start.
   */
  public void whenQuiet(Runnable action) {
    whenQuiet = action;
  }

  /** There is nothing to run. */
  void noteQuiet(Inbox inbox) {
    if (timers.next() == Long.MAX_VALUE
        && !pace.isReal()
        && !journal.hasNewsAtRest(inbox.isFilled())) {
      whenQuiet.run();
    }
  }

  /** Waits for the next deadline or message. */
  void idle(Inbox inbox) {
    if (journal.isReplay()) {
      return;
    }
    journal.idle();
    long next = timers.next();
    if (clock.isReal()) {
      inbox.listen(next == Long.MAX_VALUE ? Long.MAX_VALUE : next - clock.now());
    } else if (holders > 0) {
      inbox.await(Long.MAX_VALUE);
    } else if (pace.isReal()) {
      pace.idle(inbox, next);
    } else if (next == Long.MAX_VALUE) {
      inbox.await(Long.MAX_VALUE);
    } else if (!inbox.isFilled()) {
      clock.advanceTo(next);
    }
  }
}
