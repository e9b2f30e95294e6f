package org.urbi.kernel.job;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiFunction;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budgeted;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.StopReason;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.time.Clock;

/**
 * Requests to end running code that never lets others run, so that no message can reach it: the
 * code of a lobby whose client asked for it, a job that has held the kernel for too long, or any
 * code when the kernel must end. They are only flags: whoever wants a lobby's code ended also posts
 * a message, which {@linkplain #clear clears the flag} when it is taken.
 *
 * <p>Code that is being ended may still run its {@code finally} clauses for a moment; if it then
 * still holds the kernel, these are ended, too.
 */
public final class Interruptions {
  /**
   * How long code that is being ended may still hold the kernel, in nanoseconds; no longer than
   * half of what the budget of its lobby allows.
   */
  private static final long GRACE_PERIOD = 50_000_000;

  private static final long NONE = -1;

  /** All that a lobby runs. */
  public static final Predicate<Job> EVERYTHING = job -> true;

  /** Which code of a lobby is to end. */
  private final Map<UrbiObject, Predicate<Job>> lobbies = new ConcurrentHashMap<>();

  private final LongSupplier turns;
  private final Journal journal;
  private final Clock machine;
  private final boolean counted;
  private final DeepStack deepStack;
  private BiFunction<Job, StopReason, RuntimeException> limitFailure =
      (job, reason) -> TagStop.WHOLE_JOB;
  private volatile boolean wanted;
  private volatile boolean all;
  private final AtomicLong overdueTurn = new AtomicLong(NONE);
  private volatile StopReason overdueReason = StopReason.OVERDUE;
  private volatile Runnable changed = () -> {};
  private volatile @Nullable HoldMeter meter;

  /** The turn of a job that has run for long: what it allocates is counted. */
  private volatile long measuredTurn = NONE;

  // The following fields belong to the kernel thread: the code that is being ended at present.
  private long endingTurn = NONE;
  private StopReason ending = StopReason.NONE;

  /** What the running job allocates is counted, in its checks. */
  private boolean metered;

  /** The turn of a detached job that noticed a request of its client, and when. */
  private long askedTurn = NONE;

  private long askedSince;
  private long graceEnd;
  private @Nullable RuntimeException failure;

  /** The lobbies whose code has been ended, but whose message has not been taken yet. */
  private final Set<UrbiObject> interrupted = new HashSet<>();

  /**
   * @param turns the number of the current turn
   * @param machine measures how long code takes to end
   */
  Interruptions(LongSupplier turns, Journal journal, Clock machine) {
    this.turns = turns;
    this.journal = journal;
    this.machine = machine;
    this.deepStack = new DeepStack(turns, journal, machine);
    this.counted = journal.countsChecks();
    this.wanted = counted;
  }

  // ------------------------------------------------------------------ from any thread

  /** Ends the job that is running for that lobby, if any. */
  public void request(UrbiObject lobby) {
    request(lobby, EVERYTHING);
  }

  /**
   * The same, if it is one of those.
   *
   * @param which asked on the kernel thread, of the running job
   */
  public void request(UrbiObject lobby, Predicate<Job> which) {
    lobbies.merge(lobby, which, (before, now) -> before == EVERYTHING ? before : now);
    announce();
  }

  /** Withdraws a request: that lobby has been left, so nobody would clear it. */
  public void withdraw(UrbiObject lobby) {
    lobbies.remove(lobby);
  }

  /** Ends every job that does not let others run, from now on. */
  public void requestAll() {
    all = true;
    announce();
  }

  /** Ends the job whose turn has that number, if that turn still lasts: it has reached a limit. */
  void requestOverdue(long turn, StopReason reason) {
    overdueReason = reason;
    overdueTurn.set(turn);
    announce();
  }

  /** From now on what jobs use is measured in their checks. */
  void measure(HoldMeter meter) {
    this.meter = meter;
  }

  /** From now on what jobs use is not measured. */
  void measureNothing() {
    meter = null;
    measuredTurn = NONE;
  }

  /** Whether it is counted, for those jobs for which that is wanted. */
  boolean isMeasuring() {
    return meter != null;
  }

  /** The turn of that number, if it still lasts, is measured from now on. */
  void measureTurn(long turn) {
    if (measuredTurn != turn) {
      measuredTurn = turn;
      announce();
    }
  }

  /** Sets a listener that is called, on any thread, when {@link #arePending} may have changed. */
  public void whenChanged(Runnable listener) {
    changed = listener;
    listener.run();
  }

  /**
   * Whether there may be a request, or checks are being counted, for a recording or because what
   * the job takes is measured. Code asks this in each turn of a loop, and at each call.
   */
  public boolean arePending() {
    return wanted;
  }

  private void announce() {
    wanted = true;
    changed.run();
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Sets the exception that ends a job which has reached a limit, {@code OVERDUE} or another. */
  public void setLimitFailure(BiFunction<Job, StopReason, RuntimeException> failure) {
    limitFailure = failure;
  }

  /** When to try whether the running job can let others run. */
  DeepStack deepStack() {
    return deepStack;
  }

  /** The turn of a job begins. */
  void beginTurnOf(Job job) {
    HoldMeter meter = this.meter;
    if (meter != null || metered) {
      measure(job, meter);
    }
  }

  private void measure(Job job, @Nullable HoldMeter meter) {
    boolean limited = meter != null && (meter.isFor(job) || measuredTurn == turns.getAsLong());
    if (limited != metered) {
      metered = limited;
      update();
    }
  }

  /** Throws if the running job must end. */
  void check(Job job) {
    HoldMeter meter = this.meter;
    if (meter != null || metered) {
      measure(job, meter);
      if (meter != null && metered) {
        meter.check(job, turns.getAsLong());
        if (!counted && !isRequested()) {
          return;
        }
      }
    }
    StopReason decided = decide(job.lobby(), job);
    if (decided == StopReason.REQUESTED) {
      throw TagStop.interruption();
    } else if (decided != StopReason.NONE) {
      if (failure == null) {
        failure = limitFailure.apply(job, decided);
      }
      throw failure;
    }
  }

  /**
   * Decides whether and why the job that runs for that lobby must end, and notes that it ends now.
   */
  StopReason decide(UrbiObject lobby) {
    return decide(lobby, null);
  }

  private StopReason decide(UrbiObject lobby, @Nullable Job job) {
    StopReason decided = journal.stopReason(pendingFor(lobby, job));
    if (decided == StopReason.NONE) {
      return decided;
    }
    long turn = turns.getAsLong();
    if (endingTurn != turn) {
      endingTurn = turn;
      failure = null;
      graceEnd = machine.now() + graceOf(lobby);
      // Clear the flag, so that the same request does not end code twice: its message may have been
      // taken already while others ran.
      if (decided == StopReason.REQUESTED && lobby != null && !all) {
        lobbies.remove(lobby);
        interrupted.add(lobby);
      }
    }
    ending = decided;
    return decided;
  }

  private static long graceOf(UrbiObject lobby) {
    return lobby instanceof Budgeted owner
        ? owner.budget().holdLimit(2 * GRACE_PERIOD) / 2
        : GRACE_PERIOD;
  }

  private StopReason pendingFor(UrbiObject lobby, @Nullable Job job) {
    long turn = turns.getAsLong();
    if (endingTurn != NONE) {
      if (endingTurn == turn) {
        return machine.now() - graceEnd < 0 ? StopReason.NONE : ending;
      }
      forgetEnded(turn);
    }
    if (all || lobby != null && isRequested(lobby, job, turn)) {
      return StopReason.REQUESTED;
    }
    if (overdueTurn.get() == turn) {
      return overdueReason;
    }
    if (lobbies.isEmpty() && !counted) {
      // What was requested has been withdrawn.
      update();
    }
    return StopReason.NONE;
  }

  /**
   * Whether the code of that lobby is to end. A job that is to outlive its connection is ended by
   * its client, who leaves or wants something else ended, only if it does not let others run.
   */
  private boolean isRequested(UrbiObject lobby, @Nullable Job job, long turn) {
    Predicate<Job> which = lobbies.get(lobby);
    return which != null
        && (job == null || which.test(job) && (!job.scope().isDetached() || goesOn(turn)));
  }

  /** Whether this turn goes on although it was asked to end. */
  private boolean goesOn(long turn) {
    long now = machine.now();
    if (askedTurn != turn) {
      askedTurn = turn;
      askedSince = now;
    }
    return now - askedSince >= GRACE_PERIOD;
  }

  /** Code that had to end in an earlier turn has ended by now. */
  private void forgetEnded(long turn) {
    endingTurn = NONE;
    long known = overdueTurn.get();
    if (known != turn) {
      overdueTurn.compareAndSet(known, NONE);
    }
    update();
  }

  /**
   * To be called while an exception unwinds many calls, which takes long: lets others run if there
   * are any, and the stack is not too deep for that.
   */
  public void yieldWhileUnwinding(Job job) {
    if (job.nonInterruptible() > 0 || !deepStack.mayBePutAway()) {
      return;
    }
    // The number of the turn changes even if nobody else runs, so the state of ending this job is
    // carried over.
    Termination termination = pause();
    try {
      if (job.scheduler().hasOthers()) {
        job.yieldNow();
      }
    } catch (StackOverflowError e) {
      deepStack.refused();
    } finally {
      resume(termination);
    }
  }

  /** The state of ending the running job. */
  record Termination(StopReason ending, long until, @Nullable RuntimeException failure) {}

  /** Saves that state while the running job lets others run; null if the job is not being ended. */
  @Nullable Termination pause() {
    return endingTurn == turns.getAsLong() ? new Termination(ending, graceEnd, failure) : null;
  }

  /** Restores the state when the job continues to end. */
  void resume(@Nullable Termination paused) {
    if (paused != null) {
      endingTurn = turns.getAsLong();
      ending = paused.ending;
      graceEnd = paused.until;
      failure = paused.failure;
      announce();
    }
  }

  /** Whether code of that lobby was interrupted, and the message that says so is still to come. */
  public boolean isMessageDue(UrbiObject lobby) {
    return interrupted.contains(lobby);
  }

  /** Clears the request to interrupt the code of that lobby. */
  public void clear(UrbiObject lobby) {
    lobbies.remove(lobby);
    interrupted.remove(lobby);
    update();
  }

  private void update() {
    wanted = counted || metered;
    if (isRequested()) {
      // There are other requests, or one has arrived in the meantime.
      wanted = true;
    }
    changed.run();
  }

  private boolean isRequested() {
    return all || endingTurn != NONE || overdueTurn.get() != NONE || !lobbies.isEmpty();
  }
}
