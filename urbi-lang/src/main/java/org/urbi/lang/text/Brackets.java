package org.urbi.lang.text;

import java.util.Arrays;

/**
 * The open brackets. The parser reports brackets that do not match; here they only must not swallow
 * the statements that follow.
 */
final class Brackets {
  /** The kinds of parentheses and brackets, by the separators that may be in them. */
  enum Kind {
    /** Values, which no {@code ;} separates. */
    VALUES(0),

    /** The three clauses of a {@code for}. */
    CLAUSES(2),

    /** A condition, which may be several statements. */
    STATEMENTS(Integer.MAX_VALUE);

    private final int separators;

    Kind(int separators) {
      this.separators = separators;
    }
  }

  private byte[] open = new byte[64];
  private int[] separators = new int[64];
  private int depth;

  boolean isEmpty() {
    return depth == 0;
  }

  void clear() {
    depth = 0;
  }

  /** Opens a brace. */
  void open() {
    push('{', Integer.MAX_VALUE);
  }

  /** Opens a parenthesis or a bracket. */
  void open(char mark, Kind kind) {
    push(mark, kind.separators);
  }

  /** The innermost one that is open; empty when there is none. */
  String innermost() {
    return depth == 0 ? "" : String.valueOf((char) open[depth - 1]);
  }

  private void push(char mark, int allowed) {
    if (depth == open.length) {
      open = Arrays.copyOf(open, 2 * depth);
      separators = Arrays.copyOf(separators, 2 * depth);
    }
    separators[depth] = allowed;
    open[depth++] = (byte) mark;
  }

  /** A brace closes whatever is open inside; a parenthesis or a bracket never closes a brace. */
  void close(char c) {
    if (c == '}') {
      while (depth > 0 && open[--depth] != '{') {
        // Left open by mistake.
      }
    } else if (depth > 0 && open[depth - 1] != '{') {
      depth--;
    }
  }

  /**
   * Handles a {@code ;}. Where none is allowed, the brackets opened since the last brace cannot be
   * closed correctly any more, so they are closed here.
   */
  void separate() {
    if (depth > 0 && separators[depth - 1]-- <= 0) {
      while (depth > 0 && open[depth - 1] != '{') {
        depth--;
      }
    }
  }
}
