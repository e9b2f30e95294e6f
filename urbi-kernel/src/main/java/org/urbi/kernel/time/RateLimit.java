package org.urbi.kernel.time;

/**
 * Lets so much of something happen in a second, and as much at once after a pause. As soon as there
 * is no room for more, nothing is let through until there is all of it again: what is lost is lost
 * in one piece, of whose beginning somebody can be told. Not thread-safe.
 */
public final class RateLimit {
  private static final double SECOND = 1e9;

  private final double most;
  private double room;
  private long since;
  private boolean refusing;
  private boolean begins;

  /**
   * @param most how much in a second; {@link Long#MAX_VALUE} for no limit
   */
  public RateLimit(long most) {
    this.most = most;
    room = most;
  }

  /**
   * Takes so much, if there is room for it. What is more than all of the room is taken when all of
   * it is there, and leaves none for longer.
   *
   * @param now the time of a clock, in nanoseconds, which must not go back
   * @return whether it was taken
   */
  public boolean take(long now, long amount) {
    room = Math.min(most, room + Math.max(0, now - since) / SECOND * most);
    since = now;
    boolean refuses = refusing ? room < most : room < Math.min(amount, most);
    begins = refuses && !refusing;
    refusing = refuses;
    if (!refuses) {
      room -= amount;
    }
    return !refuses;
  }

  /** Whether there is a limit at all. */
  public boolean isLimit() {
    return most < Long.MAX_VALUE;
  }

  /** Whether what was asked for last was refused, and what was asked for before it was not. */
  public boolean beginsToRefuse() {
    return begins;
  }
}
