package org.urbi.kernel.job;

/** What long work in Java costs, in the steps of {@link Job#worked}. */
public final class Steps {
  /** Making an object, an entry, or a piece of a text. */
  public static final int OBJECT = 16;

  /** As many characters as are compared or copied in the time of a step. */
  private static final int CHARACTERS = 16;

  private Steps() {}

  /** Comparing or copying that many characters. */
  public static long ofCharacters(long count) {
    return count / CHARACTERS;
  }
}
