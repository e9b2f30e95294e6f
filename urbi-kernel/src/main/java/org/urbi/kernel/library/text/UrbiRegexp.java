package org.urbi.kernel.library.text;

import java.util.List;
import java.util.regex.Pattern;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A regular expression, and what it matched last (manual, "Regexp"). */
final class UrbiRegexp extends UrbiObject {
  private String text;
  private Pattern pattern;
  private List<String> matches = List.of();

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
    setMatches(List.of());
  }

  /** The groups of the last match, the whole of it first; empty when there was none. */
  List<String> matches() {
    noteContentRead();
    return matches;
  }

  void setMatches(List<String> others) {
    matches = others;
    noteContentChange();
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiRegexp(cloneShape(), text, pattern);
  }
}
