package urbi.spi;

/** An argument of a call cannot be converted to the type of the parameter. */
public final class ArgumentException extends RuntimeException {
  private static final long serialVersionUID = 1;

  private final int place;
  private final String expected;

  /**
   * @param place which one, from 1 on
   * @param expected the type in urbiscript
   */
  public ArgumentException(int place, String expected, RuntimeException cause) {
    super(cause.getMessage(), cause);
    this.place = place;
    this.expected = expected;
  }

  /** Which one, from 1 on. */
  public int place() {
    return place;
  }

  /** The type in urbiscript that it should have. */
  public String expected() {
    return expected;
  }
}
