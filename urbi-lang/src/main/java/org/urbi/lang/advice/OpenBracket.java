package org.urbi.lang.advice;

/**
 * A bracket that is open at the mistake.
 *
 * @param token the index of its token
 */
record OpenBracket(int token, char mark) {
  /** What closes it. */
  char closer() {
    return switch (mark) {
      case '{' -> '}';
      case '[' -> ']';
      default -> ')';
    };
  }
}
