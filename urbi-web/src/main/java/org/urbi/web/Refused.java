package org.urbi.web;

/** Somebody is not let in to a stream; the message tells him why. */
public final class Refused extends Exception {
  private static final long serialVersionUID = 1;

  private final int again;

  /**
   * @param message for people
   * @param again after how many seconds it may be worth to come again; 0 if it is of no use
   */
  public Refused(String message, int again) {
    super(message);
    this.again = again;
  }

  /** After how many seconds it may be worth to come again; 0 if it is of no use. */
  public int again() {
    return again;
  }
}
