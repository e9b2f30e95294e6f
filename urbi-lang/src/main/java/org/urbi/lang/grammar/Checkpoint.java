package org.urbi.lang.grammar;

/** Asks now and then, in a long piece of work, whether it is to go on. */
public final class Checkpoint {
  /** It goes on. */
  static final Checkpoint NONE = new Checkpoint(() -> {});

  /** So many steps are done between two questions; a power of two. */
  private static final int STEPS = 1 << 10;

  private final Runnable question;
  private int steps;

  /**
   * @param question throws an exception to end the work
   */
  public Checkpoint(Runnable question) {
    this.question = question;
  }

  /** A step of the work is done next. */
  public void pass() {
    if ((++steps & (STEPS - 1)) == 0) {
      question.run();
    }
  }
}
