package org.urbi.kernel.job;

import java.util.function.LongSupplier;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.time.Clock;

/**
 * Tells when to try whether the running job can let others run, which the virtual machine refuses
 * if the stack of the job is too large to be put away: with G1, larger than half of a region of the
 * heap. To find that out takes the machine a walk through the whole stack, so the next try comes
 * when several times as long has passed.
 */
final class DeepStack {
  private static final long FIRST_PAUSE = 10_000_000;

  /** The next try comes after so many times the time that the last one has taken. */
  private static final int PAUSES = 4;

  private static final long NONE = -1;

  private static final class RefusalRecorded extends StackOverflowError {
    private static final long serialVersionUID = 1;
  }

  private final LongSupplier turns;
  private final Journal journal;
  private final boolean counted;
  private final Clock machine;
  private long refusedTurn = NONE;
  private long tried;
  private long next;

  DeepStack(LongSupplier turns, Journal journal, Clock machine) {
    this.turns = turns;
    this.journal = journal;
    this.counted = journal.countsChecks();
    this.machine = machine;
  }

  /** Whether to try: in this turn it has not been refused, or not recently. */
  boolean mayBePutAway() {
    if (refusedTurn != turns.getAsLong()) {
      return true;
    }
    tried = machine.now();
    return journal.triesSwitchAgain(tried - next >= 0);
  }

  /**
   * To be called before each switch.
   *
   * @throws StackOverflowError if the recorded run was refused it, though this one may not be
   */
  void refuseAsRecorded() {
    if (counted && journal.refusesSwitch()) {
      throw new RefusalRecorded();
    }
  }

  /** A switch has failed: remembered if that was for the size of the stack. */
  void failed(Throwable failure) {
    if (failure instanceof StackOverflowError && !(failure instanceof RefusalRecorded)) {
      journal.switchRefused();
    }
  }

  /** The virtual machine has refused to put the stack away. */
  void refused() {
    long now = machine.now();
    long turn = turns.getAsLong();
    next = now + (refusedTurn == turn ? PAUSES * (now - tried) : FIRST_PAUSE);
    refusedTurn = turn;
  }
}
