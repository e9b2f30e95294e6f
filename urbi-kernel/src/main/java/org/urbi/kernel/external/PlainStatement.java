package org.urbi.kernel.external;

import org.urbi.lang.input.StatementReader;

/**
 * A statement between binary messages, read byte by byte; or a line that gives its source location.
 */
final class PlainStatement {
  private static final String COMMENT = "//";

  private final StringBuilder text = new StringBuilder();
  private final StatementReader reader = new StatementReader(null);
  private int fed;

  /** Adds a byte; returns true if it ends the statement. */
  boolean endsWith(char each) {
    if (text.isEmpty() && each == '\n') {
      return true;
    }
    text.append(each);
    if (isComment()) {
      return each == '\n';
    }
    if (each != ';' && each != ',') {
      return false;
    }
    reader.feed(text.substring(fed));
    fed = text.length();
    return reader.next() != null;
  }

  private boolean isComment() {
    return text.length() >= COMMENT.length()
        && text.charAt(0) == COMMENT.charAt(0)
        && text.charAt(1) == COMMENT.charAt(1);
  }

  /** The text of the statement; empty if there is none. */
  String code() {
    return isComment() ? "" : text.toString();
  }
}
