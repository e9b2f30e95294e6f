package org.urbi.kernel.library.text;

import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import org.urbi.kernel.error.Problem;

/**
 * Translates regular expressions from the Perl syntax of Boost, which programs use, to Java's:
 * {@code .} matches everything, {@code ^} matches at the start of each line, even of an empty last
 * one.
 */
final class RegexpSyntax {
  private static final int FLAGS = Pattern.MULTILINE | Pattern.UNIX_LINES | Pattern.DOTALL;

  private RegexpSyntax() {}

  /**
   * Compiles a regular expression.
   *
   * @throws PatternSyntaxException unless it is one
   */
  static Pattern compile(String text) {
    try {
      return Pattern.compile(withBeginnings(text), FLAGS);
    } catch (PatternSyntaxException e) {
      // Its place is to be one of the text that was given.
      Pattern.compile(text, FLAGS);
      throw e;
    }
  }

  /** Java's {@code ^} matches at no end of a text; so it gets an alternative that does. */
  private static String withBeginnings(String text) {
    StringBuilder out = new StringBuilder();
    int depth = 0;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '\\' && i + 1 < text.length()) {
        out.append(c).append(text.charAt(++i));
        continue;
      }
      if (c == '[') {
        depth++;
      } else if (c == ']' && depth > 0) {
        depth--;
      }
      out.append(c == '^' && depth == 0 ? "(?:^|\\A)" : String.valueOf(c));
    }
    return out.toString();
  }

  /** The error in a regular expression, in the words of Boost where it has any. */
  static String reason(String text, PatternSyntaxException e) {
    int at = Math.max(0, Math.min(e.getIndex(), text.length()));
    String what = e.getDescription();
    if (what.startsWith("Unclosed group")) {
      return Problem.UNMATCHED_PARENTHESIS.text() + place(text, text.lastIndexOf('(') + 1);
    }
    if (what.startsWith("Unmatched closing")) {
      return Problem.UNMATCHED_PARENTHESIS.text() + place(text, text.indexOf(')', at));
    }
    if (what.startsWith("Unclosed character class")) {
      return Problem.UNMATCHED_BRACKET.text() + place(text, text.length());
    }
    if (what.startsWith("Dangling meta")) {
      char operator = text.charAt(Math.min(at, text.length() - 1));
      return Problem.NOTHING_TO_REPEAT.text(operator) + place(text, at);
    }
    return Problem.OTHER_EXPRESSION_ERROR.text(what) + place(text, at);
  }

  private static String place(String text, int at) {
    int cut = at < 0 ? text.length() : at;
    return Problem.PLACE_IN_EXPRESSION.text(text.substring(0, cut), text.substring(cut));
  }
}
