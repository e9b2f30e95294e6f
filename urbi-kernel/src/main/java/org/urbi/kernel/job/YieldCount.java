package org.urbi.kernel.job;

/**
 * Counts the {@code ;} of a job that is alone, between two looks at the clock. Where a {@code ;} is
 * a matter of nanoseconds there are many of them between two looks; where the code between them
 * takes long, the clock is looked at each time, or timers would be late.
 *
 * <p>Compiled code asks only whether a {@code ;} {@linkplain #passes passes}. So a grant ends with
 * everything that the next one must not miss, but for messages, which come from other threads.
 */
public final class YieldCount {
  /** The most of them between two looks. */
  private static final int MOST = 100;

  /**
   * The most of them between two looks while a loop counts them by itself. It calls nobody, so that
   * each stays a matter of nanoseconds, which nobody knows of other code; but what follows may take
   * longer than what was measured, and a look is no longer felt among so many.
   */
  private static final int MOST_LENT = 1000;

  /**
   * How long is to pass between two looks, in nanoseconds: little for a timer, and yet a program
   * that the virtual machine still interprets does not spend a sixth of its time on looks.
   */
  private static final long LOOK_PERIOD = 100_000;

  /** How long there may be no tick at all, in nanoseconds. */
  private static final long LONGEST_TURN = 1_000_000;

  private final Inbox inbox;
  private int count;
  private int most = MOST;

  /** How many a loop that counts by itself may have between two looks. */
  private int mostLent = MOST;

  /** How many may pass before anything but news must be looked at; set when nobody else can run. */
  private int granted;

  /** How many of them are left. */
  private int left;

  /** How many more are left for a loop that counts by itself, and for nobody else. */
  private int spare;

  /** How many of both a loop that is running has borrowed, and not given back. */
  private int lent;

  /** How many of those were spare. */
  private int lentSpare;

  /** How many have passed, without those of the present grant. */
  private long passed;

  private long looked;
  private long ticked;

  YieldCount(Inbox inbox) {
    this.inbox = inbox;
  }

  /** How many there have been since the last look. */
  int count() {
    return count;
  }

  /** How many have let nobody else run, in all. */
  long passed() {
    return passed + used();
  }

  /** How many have passed because of the present grant. */
  private int used() {
    return granted - left - spare - lent;
  }

  /** Whether this one passes because of a grant: there is nothing to do. */
  public boolean passes() {
    if (left > 0 && !inbox.isFilled()) {
      left--;
      return true;
    }
    return false;
  }

  /**
   * Lends all that are left of the grant to a loop, which counts them by itself. It gives back what
   * it has not used before anybody else may ask, or end the grant; unless it has used them all.
   *
   * @return how many; none if none are left, or if there are news
   */
  public int borrow() {
    lent = 0;
    if (!inbox.isFilled()) {
      lent = left + spare;
      lentSpare = spare;
      left = 0;
      spare = 0;
    }
    return lent;
  }

  /**
   * Takes back what has been lent. What is spare is used last: others do not get more of them
   * because a loop has ended.
   *
   * @param rest how many have not been used
   */
  public void giveBack(int rest) {
    // If the stack or the memory was exhausted in the loop, it has not come here, and the grant may
    // have ended since: so many cycles at most are not counted then.
    int unused = Math.min(rest, lent);
    spare += Math.min(unused, lentSpare);
    left += Math.max(0, unused - lentSpare);
    lent = 0;
  }

  /** Lets this yield pass, and as many of the next ones, without another look at the queue. */
  void grant(long most) {
    passed++;
    left = (int) Math.max(0, Math.min(this.most - 1 - count, most));
    spare = left == 0 ? 0 : mostLent - this.most;
    granted = left + spare;
  }

  /** Somebody else may be able to run from now on: the next one has to look. */
  void endGrant() {
    // Asked several times in each turn, and hardly ever is there a grant.
    if (granted != 0) {
      passed += used();
      count += used();
      granted = 0;
      left = 0;
      spare = 0;
      lent = 0;
    }
  }

  /** Counts one; returns whether it is time for a look. */
  boolean isOver() {
    return ++count >= most;
  }

  /** The job has had its look, or others run. */
  void reset() {
    count = 0;
  }

  /** A tick begins at this time. */
  void beginTick(long now) {
    endGrant();
    looked = now;
    ticked = now;
  }

  /** The job looks at the clock; returns whether there must be a tick, whatever is to be done. */
  boolean look(long now) {
    long period = Math.max(1, now - looked);
    long fitting = count * LOOK_PERIOD / period;
    most = Math.clamp(fitting, 1, MOST);
    mostLent = Math.clamp(fitting, most, MOST_LENT);
    looked = now;
    return now - ticked >= LONGEST_TURN;
  }
}
