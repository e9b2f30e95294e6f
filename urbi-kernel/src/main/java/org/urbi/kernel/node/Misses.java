package org.urbi.kernel.node;

/** Counts how often compiled code meets what it has not expected. */
public final class Misses {
  private static final int MOST = 1000;

  private int left;

  /**
   * @param counted whether there may be too many
   */
  public Misses(boolean counted) {
    this(counted ? MOST : Integer.MAX_VALUE);
  }

  private Misses(int left) {
    this.left = left;
  }

  /** Those of code that is outdated when it is made. */
  public static Misses over() {
    return new Misses(0);
  }

  /** Counts one. */
  public void add() {
    if (left > 0) {
      left--;
    }
  }

  /** Whether there were so many that other code would be faster. */
  public boolean isOver() {
    return left == 0;
  }
}
