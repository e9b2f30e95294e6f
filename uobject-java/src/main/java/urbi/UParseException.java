package urbi;

/** A text is not the value that it should be. */
public class UParseException extends RuntimeException {
  private static final long serialVersionUID = 1;
  private final int offset;

  UParseException(String message, int offset) {
    super(message + " at offset " + offset);
    this.offset = offset;
  }

  /** Where the text is wrong. */
  public int getOffset() {
    return offset;
  }
}
