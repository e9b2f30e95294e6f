package org.urbi.kernel.library.text;

import java.util.List;
import java.util.regex.Pattern;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A regular expression, and what it matched last (manual, "Regexp"). */
final class UrbiRegexp extends UrbiObject {
  private Pattern pattern;
  private List<String> matches = List.of();

  UrbiRegexp(Shape shape, Pattern pattern) {
    super(shape);
    this.pattern = pattern;
  }

  Pattern pattern() {
    return pattern;
  }

  void setPattern(Pattern other) {
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
    return new UrbiRegexp(cloneShape(), pattern);
  }
}
