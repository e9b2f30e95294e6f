package org.urbi.kernel.uobject;

/** A function elsewhere has not taken one of its arguments; it carries no Java stack trace. */
public final class ArgumentFailure extends RuntimeException {
  private static final long serialVersionUID = 1;

  private final int place;
  private final String expected;

  /**
   * @param place which one, from 1 on
   * @param expected the type in urbiscript
   */
  public ArgumentFailure(int place, String expected) {
    super("invalid argument " + place + ", expected " + expected, null, false, false);
    this.place = place;
    this.expected = expected;
  }

  int place() {
    return place;
  }

  String expected() {
    return expected;
  }
}
