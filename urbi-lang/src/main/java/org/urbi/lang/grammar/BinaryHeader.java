package org.urbi.lang.grammar;

import org.jspecify.annotations.Nullable;

/**
 * What is between {@code BIN} and the data (manual, "Binary"): the size, the keywords, and the
 * offset of the data.
 */
record BinaryHeader(int size, String keywords, int data) {
  /** The header that starts at an offset, or null when there is none. */
  static @Nullable BinaryHeader read(String text, int from, int end) {
    var form = new BinaryScanner();
    for (int at = from; at < end; at++) {
      switch (form.accept(text.charAt(at))) {
        case COMPLETE -> {
          return new BinaryHeader(form.size(), form.keywords(), at + 1);
        }
        case NONE, NONE_IN_NUMBER -> {
          return null;
        }
        default -> {}
      }
    }
    return null;
  }
}
