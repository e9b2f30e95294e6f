package org.urbi.lang.grammar;

/**
 * Recognizes what follows {@code BIN}, one character at a time: blanks, a size, keywords, a
 * semicolon (manual, "Binary"). Anything else, and {@code BIN} is a mere name.
 */
public final class BinaryScanner {
  /** What the characters so far make. */
  public enum Answer {
    /** The beginning of a header. */
    MORE,
    /** A header: data follows. */
    COMPLETE,
    /** No header. */
    NONE,
    /** No header, and the last character continues a number. */
    NONE_IN_NUMBER
  }

  private static final int LONGEST_SIZE = 9;
  private static final int LONGEST_HEADER = 1024;

  private final StringBuilder size = new StringBuilder();
  private final StringBuilder keywords = new StringBuilder();
  private boolean blank;
  private boolean inKeywords;
  private int length;

  /** Takes the next character. */
  public Answer accept(char c) {
    boolean space = c == ' ' || c == '\t';
    if (++length > LONGEST_HEADER) {
      return Answer.NONE;
    }
    if (size.isEmpty() && space) {
      blank = true;
      return Answer.MORE;
    }
    if (!inKeywords && blank && '0' <= c && c <= '9') {
      size.append(c);
      return size.length() <= LONGEST_SIZE ? Answer.MORE : Answer.NONE_IN_NUMBER;
    }
    if (size.isEmpty()) {
      return Answer.NONE;
    }
    if (c == ';') {
      return Answer.COMPLETE;
    }
    if (!inKeywords && !space) {
      return Answer.NONE_IN_NUMBER;
    }
    inKeywords = true;
    keywords.append(c);
    return space || Character.isLetterOrDigit(c) && c < 128 || "_.-:=".indexOf(c) >= 0
        ? Answer.MORE
        : Answer.NONE;
  }

  /** How many characters of data follow. */
  public int size() {
    return Integer.parseInt(size.toString());
  }

  String keywords() {
    return keywords.toString().strip();
  }
}
