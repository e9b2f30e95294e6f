package org.urbi.kernel.job;

import java.util.function.LongSupplier;
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

  private final LongSupplier turns;
  private final Clock machine;
  private long refusedTurn = NONE;
  private long tried;
  private long next;

  DeepStack(LongSupplier turns, Clock machine) {
    this.turns = turns;
    this.machine = machine;
  }

  /** Whether to try: in this turn it has not been refused, or not recently. */
  boolean mayBePutAway() {
    if (refusedTurn != turns.getAsLong()) {
      return true;
    }
    tried = machine.now();
    return tried - next >= 0;
  }

  /** It was tried, and refused. */
  void refused() {
    long now = machine.now();
    long turn = turns.getAsLong();
    next = now + (refusedTurn == turn ? PAUSES * (now - tried) : FIRST_PAUSE);
    refusedTurn = turn;
  }
}
