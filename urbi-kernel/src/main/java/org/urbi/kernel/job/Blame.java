package org.urbi.kernel.job;

import java.util.function.LongSupplier;
import org.urbi.kernel.time.RandomNumbers;

/**
 * What the turns of a round cost, and who is to blame if the round is cut short: one of those that
 * had a turn in it, or the machine, drawn by lot according to the time they took; and one of those
 * that took next to none. They are known by the order in which they had their turns.
 */
final class Blame {
  /** Who takes less time in a round, in nanoseconds, delays nobody and is hardly ever to blame. */
  static final long LITTLE = RunQueue.SLICE / 10;

  /** Only a hundredth of that part of each turn counts, when lots are drawn for who is to blame. */
  private static final long LITTLE_COUNTS = 100;

  /** How long the processor time is taken to pass as fast as all time, in nanoseconds. */
  private static final long WORK_LOOK = 100_000;

  /** No lobby: behind all indexes. */
  private static final int MACHINE = Integer.MAX_VALUE;

  private final LongSupplier worked;
  private final RandomNumbers lots = new RandomNumbers();

  /** The index of the one whose turn it is. */
  private int turn;

  /** When its turn began. */
  private long turnBegan;

  /** The processor time when its turn began, or before. */
  private long workedBefore;

  /** The processor time when it was read last. */
  private long workedAtLook;

  /** When the processor time was read last. */
  private long workLooked;

  /** How long its turn has taken, without what the machine did besides. */
  private long turnTook;

  /** How many lots, each for a nanosecond that counts, it has in its turn. */
  private long turnLots;

  /** For how long it did not run in its turn, because the machine did something else. */
  private long turnLost;

  /** How many lots all that have had a turn in this round have together. */
  private long drawn;

  private int culprit;
  private int modest;

  /** How many took next to no time. */
  private int modestOnes;

  /**
   * @param worked the processor time of the loop, in nanoseconds, or {@link HoldWatchdog#UNKNOWN}
   */
  Blame(LongSupplier worked) {
    this.worked = worked;
  }

  /** A round begins. */
  void beginRound() {
    culprit = MACHINE;
    modest = MACHINE;
    modestOnes = 0;
    drawn = 0;
  }

  /** The turns of a round begin, which can be cut short. */
  void beginLook(long now) {
    workedAtLook = worked.getAsLong();
    workLooked = now;
  }

  /** The turn of that index begins. */
  void beginTurn(int index, long now) {
    turn = index;
    turnBegan = now;
    workedBefore = workedAtLook;
    turnTook = 0;
    turnLots = 0;
    turnLost = 0;
  }

  /** When the turn began that lasts. */
  long turnBegan() {
    return turnBegan;
  }

  /** That turn is over. */
  void endTurn() {
    if (turnTook < LITTLE && lots.below(++modestOnes) == 0) {
      modest = turn;
    }
  }

  /** All have had turns together, the last one, whose index is 0, for that long. */
  void lookTogether(long taken) {
    culprit = taken < LITTLE ? MACHINE : 0;
  }

  /**
   * The turn lasts until now: its time and that of the machine count. To read the processor time
   * takes longer than a short job.
   */
  void look(long now) {
    long time = now - turnBegan;
    long own = time;
    if (time >= LITTLE && workedBefore != HoldWatchdog.UNKNOWN) {
      if (now - workLooked >= WORK_LOOK) {
        beginLook(now);
      }
      own = Math.min(time, workedAtLook - workedBefore + now - workLooked);
    }
    turnTook = own;
    long all = lotsFor(own);
    draw(Math.max(0, all - turnLots), turn);
    draw(Math.max(0, time - own - turnLost), MACHINE);
    turnLots = Math.max(turnLots, all);
    turnLost = Math.max(turnLost, time - own);
  }

  /** Gives somebody that many more lots; each lot of the round is as likely to be drawn. */
  private void draw(long more, int whose) {
    drawn += more;
    if (more > 0 && lots.below(drawn) < more) {
      culprit = whose;
    }
  }

  private static long lotsFor(long time) {
    return Math.min(time, LITTLE) / LITTLE_COUNTS + Math.max(0, time - LITTLE);
  }

  /**
   * Who is to blame for this round, and who is not at all, as one number.
   *
   * @param nobody behind all indexes
   */
  int verdict(int nobody) {
    return Math.min(modest, nobody) * (nobody + 1) + Math.min(culprit, nobody);
  }

  /** Makes what {@link #verdict} has said the truth, which may have been recorded. */
  void settle(int verdict, int nobody) {
    culprit = verdict % (nobody + 1);
    modest = verdict / (nobody + 1);
  }

  /** The index of who is to blame, or one behind all. */
  int culprit() {
    return culprit;
  }

  /** The index of one that took next to no time, or one behind all. */
  int modest() {
    return modest;
  }
}
