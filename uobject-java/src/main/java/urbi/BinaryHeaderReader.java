package urbi;

/** Reads the words of the header of a binary. */
final class BinaryHeaderReader {
  private final String[] words;
  private int next = 1;

  BinaryHeaderReader(String header) {
    words = header.strip().split("\\s+");
  }

  static String first(String header) {
    int end = 0;
    while (end < header.length() && header.charAt(end) > ' ') {
      end++;
    }
    return header.substring(0, end);
  }

  /** Passes over the next word. */
  void skip() {
    next++;
  }

  /** The next word as a number; 0 when there is none. */
  int number() {
    if (next >= words.length) {
      return 0;
    }
    try {
      return Math.max(0, Integer.parseInt(words[next++]));
    } catch (NumberFormatException e) {
      return 0;
    }
  }
}
