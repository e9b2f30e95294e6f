package org.urbi.kernel.library.reference;

import java.util.ArrayList;
import java.util.List;
import org.urbi.lang.source.Span;

/** The comment that stands directly above code: what its author says of it. */
final class CommentAbove {
  /** How many lines are read. */
  private static final int MOST = 50;

  private CommentAbove() {}

  /** Its lines, without the marks of the comment. */
  static List<String> of(Span code) {
    String text = code.source().text();
    int begin = text.lastIndexOf('\n', Math.min(code.begin(), text.length()) - 1) + 1;
    List<String> above = new ArrayList<>();
    boolean block = false;
    while (begin > 0 && above.size() < MOST) {
      int end = begin - 1;
      begin = text.lastIndexOf('\n', end - 1) + 1;
      String line = text.substring(begin, end).strip();
      if (!block && line.endsWith("*/")) {
        block = true;
      } else if (!block && !line.startsWith("//") || line.startsWith("//#")) {
        break;
      }
      above.addFirst(unmarked(line));
      if (block && line.startsWith("/*")) {
        break;
      }
    }
    above.removeIf(String::isEmpty);
    return above;
  }

  private static String unmarked(String line) {
    return line.replaceFirst("^(//+!?|/\\*+!?|\\*(?!/))", "").replaceFirst("\\*/$", "").strip();
  }
}
