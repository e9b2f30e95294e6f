package org.urbi.lang.grammar;

/** Shows a character that may not be printable (manual, "Characters, encoding"). */
final class CharacterDisplay {
  private CharacterDisplay() {}

  /** The character itself, or {@code \xc3}. */
  static String show(char c) {
    return ' ' <= c && c < 127 ? String.valueOf(c) : String.format("\\x%02x", (int) c);
  }
}
