package urbi.spi;

/** The urbiscript code that a UObject sends: each text is executed for itself. */
public final class SentCode {
  private static final String SEPARATORS = ";,|&";

  private SentCode() {}

  /**
   * Ends the last statement of a text, so that the next text does not continue it.
   *
   * @return the text, with a separator where it has none at its end
   */
  public static String whole(String code) {
    String text = code.stripTrailing();
    boolean ended = text.isEmpty() || SEPARATORS.indexOf(text.charAt(text.length() - 1)) >= 0;
    // The text may end with a comment.
    return ended ? code : code + "\n;";
  }
}
