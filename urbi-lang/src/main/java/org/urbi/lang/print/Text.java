package org.urbi.lang.print;

/**
 * A text that is written from its beginning to its end, by all printers.
 *
 * <p>No part of it is ever a string of its own, because to join and to indent such parts again and
 * again is most of the work of printing in a process that has only just started. A line is indented
 * when it begins; if it turns out to be empty, or to fit on the one before, it is taken back
 * afterwards.
 */
class Text {
  private static final int STEP = 2;
  private static final int WIDEST = 64;
  private static final String LINE = "\n" + " ".repeat(WIDEST);

  private final StringBuilder text = new StringBuilder(256);
  private int margin;
  private int lines;

  void add(char c) {
    text.append(c);
  }

  /** Adds what has no line feed. */
  void add(String piece) {
    text.append(piece);
  }

  /** Adds an identifier. */
  void name(String name) {
    StringEscape.appendName(text, name);
  }

  /** Adds a string as a literal. */
  void quote(String value) {
    StringEscape.appendQuoted(text, value);
  }

  /** Begins another line. */
  void line() {
    lines++;
    if (margin <= WIDEST) {
      text.append(LINE, 0, margin + 1);
    } else {
      text.append(LINE).repeat(' ', margin - WIDEST);
    }
  }

  /** How many lines have been begun and are lines still. */
  int lines() {
    return lines;
  }

  /** Lines that begin from now on are further to the right. */
  void more() {
    margin += STEP;
  }

  /** Ends what {@link #more} began. */
  void less() {
    margin -= STEP;
  }

  /** Begins a line that is further to the right, as those after it are; returns where it begins. */
  int indent() {
    int begin = text.length();
    margin += STEP;
    line();
    return begin;
  }

  /** Ends what {@link #indent} began; whether anything was written: if not, no line is left. */
  boolean outdent(int begin) {
    margin -= STEP;
    if (text.length() > begin + 1 + margin + STEP) {
      return true;
    }
    text.setLength(begin);
    lines--;
    return false;
  }

  /** After {@link #outdent}: puts the line that begins there on the one before, after a space. */
  void join(int begin) {
    text.delete(begin, begin + margin + STEP);
    lines--;
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
