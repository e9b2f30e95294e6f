package org.urbi.server.net;

/**
 * Detects which bytes of a stream of urbiscript are the payload of a binary literal: in {@code BIN
 * 4 jpeg 2 2;abcd} the four bytes after the semicolon, and likewise in {@code "\\B(4)(abcd)"}. They
 * may have any value, and must not be mistaken for telnet commands.
 *
 * <p>It does not recognise strings or comments. In the worst case, after a string that looks like a
 * binary literal, a telnet command goes to the parser.
 */
final class BinaryLiteralDetector {
  private static final String WORD = "BIN";
  private static final String ESCAPE_BEFORE = "B(";
  private static final String ESCAPE_AFTER = ")(";
  private static final int MAX_HEADER = 1024;

  private enum State {
    TEXT,
    ESCAPE,
    SIZE,
    KEYWORDS,
    PAYLOAD
  }

  private State state = State.TEXT;
  private int matched;
  private boolean inWord;
  private int headerLength;
  private boolean sized;
  private long size;

  /** Whether the next byte is part of a payload. */
  boolean inPayload() {
    return state == State.PAYLOAD;
  }

  /** Takes the next byte into account. */
  void accept(byte b) {
    switch (state) {
      case TEXT -> text(b);
      case ESCAPE -> escape(b);
      case SIZE, KEYWORDS -> header(b);
      case PAYLOAD -> {
        if (--size == 0) {
          reset();
        }
      }
    }
  }

  private void text(byte b) {
    if (b == '\\') {
      state = State.ESCAPE;
      matched = 0;
      sized = false;
      size = 0;
      return;
    }
    boolean letter = Character.isLetterOrDigit(b & 0xff) || b == '_';
    if (matched == WORD.length() && (b == ' ' || b == '\t')) {
      state = State.SIZE;
      headerLength = 0;
      sized = false;
      size = 0;
      return;
    }
    boolean next = matched < WORD.length() && b == WORD.charAt(matched);
    matched = next && (matched > 0 || !inWord) ? matched + 1 : 0;
    inWord = letter;
  }

  /** Handles the bytes after a backslash: {@code B(size)(}, or anything else. */
  private void escape(byte b) {
    int after = matched - ESCAPE_BEFORE.length();
    if (after < 0 && b == ESCAPE_BEFORE.charAt(matched)
        || after >= 0 && sized && b == ESCAPE_AFTER.charAt(after)) {
      matched++;
    } else if (after == 0 && b >= '0' && b <= '9') {
      sized = true;
      size = Math.min(size * 10 + (b - '0'), Integer.MAX_VALUE);
    } else {
      boolean first = matched == 0;
      reset();
      if (!first) {
        text(b);
      }
    }
    if (state == State.ESCAPE && after == ESCAPE_AFTER.length() - 1) {
      state = State.PAYLOAD;
      if (size == 0) {
        reset();
      }
    }
  }

  private void header(byte b) {
    if (++headerLength > MAX_HEADER) {
      reset();
    } else if (b == ';' || b == '\n') {
      state = State.PAYLOAD;
      if (!sized || size == 0) {
        reset();
      }
    } else if (state == State.SIZE && b >= '0' && b <= '9') {
      sized = true;
      size = Math.min(size * 10 + (b - '0'), Integer.MAX_VALUE);
    } else if (state == State.SIZE && sized) {
      state = State.KEYWORDS;
    } else if (state == State.SIZE && b != ' ' && b != '\t') {
      reset();
    }
  }

  private void reset() {
    state = State.TEXT;
    matched = 0;
    inWord = false;
  }
}
