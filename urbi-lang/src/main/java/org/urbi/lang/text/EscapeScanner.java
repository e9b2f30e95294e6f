package org.urbi.lang.text;

/**
 * Finds the end of an escape in a string, one character at a time. All escapes are one character
 * long, except for {@code \B(size)(contents)}, whose contents are verbatim (manual, "Strings").
 */
final class EscapeScanner {
  enum Answer {
    /** The escape goes on. */
    MORE,
    /** The character was the last of the escape. */
    DONE,
    /** The escape ended before the character. */
    REFUSED
  }

  private enum State {
    ESCAPE,
    OPEN,
    SIZE,
    MIDDLE,
    CONTENTS,
    CLOSE
  }

  private static final int LONGEST_SIZE = 10;

  private State state = State.ESCAPE;
  private long size;
  private int digits;

  void start() {
    state = State.ESCAPE;
  }

  Answer accept(char c, char quote) {
    switch (state) {
      case ESCAPE -> {
        state = State.OPEN;
        return c == 'B' ? Answer.MORE : Answer.DONE;
      }
      case OPEN -> {
        size = 0;
        digits = 0;
        return expect('(', c, quote, State.SIZE);
      }
      case SIZE -> {
        if ('0' <= c && c <= '9' && digits < LONGEST_SIZE) {
          digits++;
          size = size * 10 + c - '0';
          return Answer.MORE;
        }
        return expect(digits == 0 ? 0 : ')', c, quote, State.MIDDLE);
      }
      case MIDDLE -> {
        return expect('(', c, quote, size == 0 ? State.CLOSE : State.CONTENTS);
      }
      case CONTENTS -> {
        if (--size == 0) {
          state = State.CLOSE;
        }
        return Answer.MORE;
      }
      default -> {
        // Accept any character in place of the parenthesis, as the scanner does.
        return Answer.DONE;
      }
    }
  }

  private Answer expect(int expected, char c, char quote, State next) {
    if (c == expected) {
      state = next;
      return Answer.MORE;
    }
    return c == quote ? Answer.REFUSED : Answer.DONE;
  }
}
