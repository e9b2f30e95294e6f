package org.urbi.kernel.library.text;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.regex.PatternSyntaxException;

/**
 * A regular expression in the syntax of Perl, made one of Java whose matching can be ended.
 *
 * <p>What can be ended is what looks at the text. The expression of a hostile client need not: an
 * empty group that is to be there a billion times, or many anchors each of which may be there or
 * not. So each group begins by looking at something, and so does each repetition of an anchor, and
 * of nothing, as behind another quantifier ({@code a{2}{3}}); what is looked at is always there.
 */
final class RegexpTranslation {
  /**
   * Looks ahead at nothing. As a matcher with transparent bounds does so, it asks how long the text
   * is.
   */
  private static final String LOOK = "(?=)";

  /** Java's {@code ^} matches at no end of a text; so it gets an alternative that does. */
  private static final String BEGINNING = "(?:^|\\A)";

  /** How often something must be there at most: so much of nothing is gone through at once. */
  private static final int MOST_REPETITIONS = 1 << 20;

  private static final String ANCHORS = "bBAGzZk";
  private static final String BRACED = "xpPNb";
  private static final String SPACES = " \t\n\013\f\r";
  private static final String FLAGS = "idmsuxU-";

  private final String text;
  private final StringBuilder out;
  private int at;

  /** For the groups around, the innermost first: whether spaces and comments count for nothing. */
  private final Deque<Boolean> around = new ArrayDeque<>();

  private boolean spaced;

  private RegexpTranslation(String text) {
    this.text = text;
    this.out = new StringBuilder(text.length());
  }

  /**
   * Translates an expression.
   *
   * @throws PatternSyntaxException if something is to be there too often
   */
  static String of(String text) {
    RegexpTranslation translation = new RegexpTranslation(text);
    while (translation.at < text.length()) {
      translation.piece();
    }
    return translation.out.toString();
  }

  private boolean isAt(char c) {
    return at < text.length() && text.charAt(at) == c;
  }

  private void copy() {
    out.append(text.charAt(at++));
  }

  private void copyThrough(String end) {
    int found = text.indexOf(end, at);
    int after = found < 0 ? text.length() : found + end.length();
    out.append(text, at, after);
    at = after;
  }

  private void piece() {
    switch (text.charAt(at)) {
      case '\\' -> escape();
      case '[' -> characterClass();
      case '(' -> group();
      case ')' -> {
        copy();
        spaced = !around.isEmpty() && around.pop();
        quantifier();
      }
      case '^' -> {
        int begins = out.length();
        at++;
        out.append(BEGINNING);
        anchored(begins);
      }
      case '$' -> {
        int begins = out.length();
        copy();
        anchored(begins);
      }
      case '{' -> nothing();
      default -> {
        int begins = at;
        skipSpaces();
        if (at == begins) {
          literal();
        }
      }
    }
  }

  private void literal() {
    copy();
    quantifier();
  }

  /** Nothing, which is repeated. */
  private void nothing() {
    out.append(LOOK);
    quantifier();
  }

  /** An anchor, which begins there in the translation, may be repeated. */
  private void anchored(int begins) {
    int ends = out.length();
    if (quantifier()) {
      out.insert(ends, LOOK + ")").insert(begins, "(?:");
    }
  }

  private void escape() {
    int begins = out.length();
    copy();
    if (at == text.length()) {
      return;
    }
    char c = text.charAt(at);
    copy();
    if (c == 'Q') {
      int quoted = at;
      copyThrough("\\E");
      boolean empty = at == quoted + 2;
      skipSpaces();
      if (empty && isAt('{')) {
        nothing();
        return;
      }
    } else if (BRACED.indexOf(c) >= 0 && isAt('{')) {
      copyThrough("}");
    } else if (c == 'k') {
      copyThrough(">");
    }
    boolean reference = c >= '1' && c <= '9';
    while (reference && at < text.length() && Character.isDigit(text.charAt(at))) {
      copy();
    }
    if (reference || ANCHORS.indexOf(c) >= 0) {
      anchored(begins);
    } else {
      quantifier();
    }
  }

  private void characterClass() {
    int depth = 0;
    do {
      char c = text.charAt(at);
      copy();
      if (c == '\\' && at < text.length()) {
        char escaped = text.charAt(at);
        copy();
        if (escaped == 'Q') {
          copyThrough("\\E");
        }
      } else if (c == '[') {
        depth++;
        if (isAt('^')) {
          copy();
        }
        if (isAt(']')) {
          // The first one is a character as any other.
          copy();
        }
      } else if (c == ']') {
        depth--;
      }
    } while (depth > 0 && at < text.length());
    quantifier();
  }

  private void group() {
    copy();
    around.push(spaced);
    skipSpaces();
    if (!isAt('?')) {
      out.append(LOOK);
      return;
    }
    copy();
    boolean positive = true;
    while (at < text.length() && FLAGS.indexOf(text.charAt(at)) >= 0) {
      char flag = text.charAt(at);
      positive &= flag != '-';
      if (flag == 'x') {
        spaced = positive;
      }
      copy();
    }
    if (isAt(')')) {
      // The flags are for the rest of the group around.
      copy();
      around.pop();
      return;
    }
    if (isAt('<')) {
      copy();
      if (isAt('=') || isAt('!')) {
        copy();
      } else {
        copyThrough(">");
      }
    } else if (at < text.length()) {
      copy();
    }
    out.append(LOOK);
  }

  private void skipSpaces() {
    while (spaced && at < text.length()) {
      if (isAt('#')) {
        copyThrough("\n");
      } else if (SPACES.indexOf(text.charAt(at)) >= 0) {
        copy();
      } else {
        return;
      }
    }
  }

  /** Copies a quantifier, if there is one; returns whether there is. */
  private boolean quantifier() {
    skipSpaces();
    if (isAt('{')) {
      checkRepetitions();
      copyThrough("}");
    } else if (isAt('?') || isAt('*') || isAt('+')) {
      copy();
    } else {
      return false;
    }
    skipSpaces();
    if (isAt('?') || isAt('+')) {
      copy();
    }
    return true;
  }

  private void checkRepetitions() {
    long count = 0;
    for (int i = at + 1; i < text.length() && "},".indexOf(text.charAt(i)) < 0; i++) {
      int digit = Character.digit(text.charAt(i), 10);
      count = digit < 0 ? count : 10 * count + digit;
      if (count > MOST_REPETITIONS) {
        throw new PatternSyntaxException("Illegal repetition range", text, at);
      }
    }
  }
}
