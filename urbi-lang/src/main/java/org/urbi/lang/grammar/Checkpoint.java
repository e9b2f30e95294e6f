package org.urbi.lang.grammar;

/** Checks regularly in long loops whether to continue. */
public final class Checkpoint {
  /** Lets the parser go on. */
  static final Checkpoint NONE = new Checkpoint(() -> {});

  /** The number of steps between two checks; a power of two. */
  private static final int STEPS = 1 << 10;

  private final Runnable question;
  private int steps;

  /**
   * @param question throws an exception to end the work
   */
  public Checkpoint(Runnable question) {
    this.question = question;
  }

  /** To be called before each step. */
  public void pass() {
    if ((++steps & (STEPS - 1)) == 0) {
      question.run();
    }
  }
}
