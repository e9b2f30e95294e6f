package org.urbi.lang.parse;

import java.util.List;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.TerminalNode;

/** The values of the literal words. */
final class Literals {
  private Literals() {}

  static double number(String written) {
    String text = written.replace("_", "");
    if (!text.startsWith("0x")) {
      return Double.parseDouble(text);
    }
    double value = 0;
    for (int i = 2; i < text.length(); i++) {
      value = value * 16 + Character.digit(text.charAt(i), 16);
    }
    return value;
  }

  /** In radians. */
  static double angle(String text) {
    if (text.endsWith("grad")) {
      return number(text.substring(0, text.length() - 4)) * Math.PI / 200;
    }
    double value = number(text.substring(0, text.length() - 3));
    return text.endsWith("deg") ? value * Math.PI / 180 : value;
  }

  /** In seconds; the words may be made of several durations. */
  static double duration(List<TerminalNode> words) {
    double seconds = 0;
    for (TerminalNode word : words) {
      seconds += duration(word.getText());
    }
    return seconds;
  }

  private static double duration(String text) {
    double seconds = 0;
    int begin = 0;
    while (begin < text.length()) {
      int unit = begin;
      while (!unitAt(text, unit)) {
        unit++;
      }
      int end = unit;
      while (end < text.length() && Character.isLetter(text.charAt(end))) {
        end++;
      }
      double value = number(text.substring(begin, unit));
      seconds +=
          switch (text.substring(unit, end)) {
            case "ms" -> value / 1000;
            case "m", "min" -> value * 60;
            case "h" -> value * 3600;
            case "d" -> value * 86400;
            default -> value;
          };
      begin = end;
    }
    return seconds;
  }

  private static boolean unitAt(String text, int at) {
    return "msdh".indexOf(text.charAt(at)) >= 0;
  }

  static String string(List<TerminalNode> words) {
    var value = new StringBuilder();
    for (TerminalNode word : words) {
      value.append(Escapes.value(word.getText()));
    }
    return value.toString();
  }

  /** The name an identifier stands for. */
  static String name(Token token) {
    String text = token.getText();
    if (text.startsWith("'")) {
      return Escapes.value(text);
    }
    boolean operator =
        text.startsWith("operator")
            && text.length() > 8
            && !Character.isJavaIdentifierPart(text.charAt(8));
    return operator ? text.substring(8).strip() : text;
  }
}
