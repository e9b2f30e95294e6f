package urbi.remote;

/** An argument of a call cannot be what the function wants. */
final class ArgumentException extends RuntimeException {
  private static final long serialVersionUID = 1;

  private final int place;
  private final String expected;

  /**
   * @param place which one, from 1 on
   * @param expected the type in urbiscript
   */
  ArgumentException(int place, String expected, RuntimeException cause) {
    super(cause.getMessage(), cause);
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
