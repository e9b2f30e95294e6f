package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.time.Clock;

/**
 * Measures how long the turns of each job last, while somebody looks, and keeps the latest ones of
 * the jobs that are traced. On the kernel thread.
 */
final class TurnMeter {
  /** How many turns are kept: whoever looks too rarely misses some. */
  private static final int KEPT = 1 << 13;

  private final Clock machine;
  private final @Nullable Turn[] kept = new Turn[KEPT];
  private long next;
  private @Nullable Job charged;
  private long since;
  private Wait before = Wait.TURN;
  private long waker;

  TurnMeter(Clock machine) {
    this.machine = machine;
  }

  /** The turn passes to a job; null if to none. */
  void turnOf(@Nullable Job following) {
    if (following == charged) {
      return;
    }
    long now = machine.now();
    Job done = charged;
    if (done != null) {
      done.charge(now - since);
      if (done.isTraced()) {
        boolean ended = done.state() == Job.State.ENDED;
        kept[(int) (next++ % KEPT)] = new Turn(done.number(), waker, since, now, before, ended);
      }
    }
    if (following != null) {
      before = following.waitsFor();
      waker = following.waker();
    }
    charged = following;
    since = now;
  }

  /** The number that the next turn gets. */
  long next() {
    return next;
  }

  /** The turns from that number on, as far as they are still kept. */
  List<Turn> turns(long from) {
    List<Turn> turns = new ArrayList<>();
    for (long at = Math.max(from, next - KEPT); at < next; at++) {
      Turn turn = kept[(int) (at % KEPT)];
      if (turn != null) {
        turns.add(turn);
      }
    }
    return turns;
  }
}
