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
      return Pattern.compile(RegexpTranslation.of(text), FLAGS);
    } catch (PatternSyntaxException e) {
      // Its place is to be one of the text that was given.
      Pattern.compile(text, FLAGS);
      throw e;
    }
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
