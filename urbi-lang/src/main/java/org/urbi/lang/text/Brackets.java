package org.urbi.lang.text;

import java.util.Arrays;

/**
 * The brackets that are open. Those that do not match are errors for the parser to tell; here they
 * only must not swallow the statements that follow.
 */
final class Brackets {
  private byte[] open = new byte[64];
  private int depth;

  boolean isEmpty() {
    return depth == 0;
  }

  void clear() {
    depth = 0;
  }

  void open(char c) {
    if (depth == open.length) {
      open = Arrays.copyOf(open, 2 * depth);
    }
    open[depth++] = (byte) c;
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
}
