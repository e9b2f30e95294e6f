package org.urbi.kernel.uobject;

import org.urbi.kernel.error.Problem;

/** A function of a remote process has rejected one of its arguments. It has no Java stack trace. */
public final class ArgumentFailure extends RuntimeException {
  private static final long serialVersionUID = 1;

  private final int place;
  private final String expected;

  /**
   * @param place the number of the argument, from 1
   * @param expected the type in urbiscript
   */
  public ArgumentFailure(int place, String expected) {
    super(Problem.REJECTED_ARGUMENT.text(place, expected), null, false, false);
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
