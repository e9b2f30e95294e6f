package org.urbi.kernel.library.text;

import java.util.regex.Pattern;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A regular expression, and what it matched last (manual, "Regexp"). */
final class UrbiRegexp extends UrbiObject {
  private String text;
  private Pattern pattern;

  /** What was looked through last, and where each group begins and ends in it, -1 for nowhere. */
  private String seen = "";

  private int[] groups = {};

  UrbiRegexp(Shape shape, String text, Pattern pattern) {
    super(shape);
    this.text = text;
    this.pattern = pattern;
  }

  /** As it was written. */
  String text() {
    return text;
  }

  Pattern pattern() {
    return pattern;
  }

  void setPattern(String written, Pattern other) {
    text = written;
    pattern = other;
    setMatch("", new int[0]);
  }

  /** How many groups the last match has, the whole of it counted; none when there was none. */
  int groups() {
    noteContentRead();
    return groups.length / 2;
  }

  /** A group of the last match, 0 for the whole; empty if it takes no part in it. */
  String group(int number) {
    noteContentRead();
    int begin = groups[2 * number];
    return begin < 0 ? "" : seen.substring(begin, groups[2 * number + 1]);
  }

  /**
   * Notes a match; thousands of groups may have the whole text each, so they are copied when
   * somebody asks for them.
   *
   * @param places where each group begins and ends in the text, the whole first
   */
  void setMatch(String looked, int[] places) {
    seen = looked;
    groups = places;
    noteContentChange();
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiRegexp(cloneShape(), text, pattern);
  }
}
