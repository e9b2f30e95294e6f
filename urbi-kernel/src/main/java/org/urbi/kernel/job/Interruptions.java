package org.urbi.kernel.job;

import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.StopReason;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.time.Clock;

/**
 * The running code that is to end although it never lets others run, so that no message can reach
 * it: that of a lobby whose client wants it, of a job that has held the kernel for too long, or
 * whatever runs when the kernel is to end. Flags only: who wants a lobby's code ended posts a
 * message besides, which {@linkplain #clear takes the flag back} when its turn comes.
 *
 * <p>Code that ends may run its {@code finally} clauses for a moment; what then still holds the
 * kernel ends without any more of that.
 */
public final class Interruptions {
  /** How long code that ends may go on without letting others run, in nanoseconds. */
  private static final long GRACE_PERIOD = 50_000_000;

  private static final long NONE = -1;

  private final Set<UrbiObject> lobbies = ConcurrentHashMap.newKeySet();
  private final LongSupplier turns;
  private final Journal journal;
  private final Clock machine;
  private final boolean counted;
  private Function<Job, RuntimeException> overdueFailure = job -> new TagStop(null, null);
  private volatile boolean wanted;
  private volatile boolean all;
  private final AtomicLong overdueTurn = new AtomicLong(NONE);
  private volatile Runnable changed = () -> {};

  // These are the kernel thread's own: what ends right now.
  private long endingTurn = NONE;
  private StopReason ending = StopReason.NONE;
  private long graceEnd;
  private @Nullable RuntimeException failure;

  /** The lobbies of which code has ended, and whose message has not come yet. */
  private final Set<UrbiObject> interrupted = new HashSet<>();

  /**
   * @param turns gives the number of the turn that goes on
   * @param machine tells how long code takes to end
   */
  Interruptions(LongSupplier turns, Journal journal, Clock machine) {
    this.turns = turns;
    this.journal = journal;
    this.machine = machine;
    this.counted = journal.countsChecks();
    this.wanted = counted;
  }

  // ------------------------------------------------------------------ from any thread

  /** Has the job end that is running for that lobby, if there is one. */
  public void request(UrbiObject lobby) {
    lobbies.add(lobby);
    announce();
  }

  /** Has every job end from now on that does not let others run. */
  public void requestAll() {
    all = true;
    announce();
  }

  /** Has the job end whose turn has that number, if it still lasts. */
  void requestOverdue(long turn) {
    overdueTurn.set(turn);
    announce();
  }

  /**
   * Sets who is told, on whatever thread, when there may be some where there were none, or back.
   */
  public void whenChanged(Runnable listener) {
    changed = listener;
    listener.run();
  }

  /**
   * Whether there is any, or it counts how often that is asked; code looks at this in each turn of
   * a loop, and at each call.
   */
  public boolean arePending() {
    return wanted;
  }

  private void announce() {
    wanted = true;
    changed.run();
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Sets what a job is left with that has held the kernel for too long. */
  public void setOverdueFailure(Function<Job, RuntimeException> failure) {
    overdueFailure = failure;
  }

  /** Ends the running job here, if it is to end. */
  void check(Job job) {
    StopReason decided = decide(job.lobby());
    if (decided == StopReason.REQUESTED) {
      throw TagStop.interruption();
    } else if (decided == StopReason.OVERDUE) {
      if (failure == null) {
        failure = overdueFailure.apply(job);
      }
      throw failure;
    }
  }

  /** How the job is to end that runs for that lobby; it does so then. */
  StopReason decide(UrbiObject lobby) {
    StopReason decided = journal.stopReason(pendingFor(lobby));
    if (decided == StopReason.NONE) {
      return decided;
    }
    long turn = turns.getAsLong();
    if (endingTurn != turn) {
      endingTurn = turn;
      failure = null;
      graceEnd = machine.now() + GRACE_PERIOD;
      // Not again for the same ending: its message may have come while others were let run.
      if (decided == StopReason.REQUESTED && lobby != null && !all) {
        lobbies.remove(lobby);
        interrupted.add(lobby);
      }
    }
    ending = decided;
    return decided;
  }

  private StopReason pendingFor(UrbiObject lobby) {
    long turn = turns.getAsLong();
    if (endingTurn != NONE) {
      if (endingTurn == turn) {
        return machine.now() - graceEnd < 0 ? StopReason.NONE : ending;
      }
      forgetEnded(turn);
    }
    if (all || lobby != null && lobbies.contains(lobby)) {
      return StopReason.REQUESTED;
    }
    return overdueTurn.get() == turn ? StopReason.OVERDUE : StopReason.NONE;
  }

  /** What was to end in an earlier turn has done so. */
  private void forgetEnded(long turn) {
    endingTurn = NONE;
    long known = overdueTurn.get();
    if (known != turn) {
      overdueTurn.compareAndSet(known, NONE);
    }
    update();
  }

  /** How the running job ends, if it does. */
  record Termination(StopReason ending, long until, @Nullable RuntimeException failure) {}

  /** The running job lets others run while it ends; null if it does not end. */
  @Nullable Termination pause() {
    return endingTurn == turns.getAsLong() ? new Termination(ending, graceEnd, failure) : null;
  }

  /** It goes on to end. */
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

  /** The code of that lobby is not to be interrupted any more. */
  public void clear(UrbiObject lobby) {
    lobbies.remove(lobby);
    interrupted.remove(lobby);
    update();
  }

  private void update() {
    wanted = counted;
    if (all || endingTurn != NONE || overdueTurn.get() != NONE || !lobbies.isEmpty()) {
      // Others wait, or one has come between the two.
      wanted = true;
    }
    changed.run();
  }
}
