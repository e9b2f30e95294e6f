package org.urbi.tests;

import java.util.List;
import java.util.Random;

/** Makes programs that nobody would write, the same ones from the same seed. */
final class ProgramGenerator {
  /**
   * Everything that may stand in a program, but for the loops that never give way and for what ends
   * a session.
   */
  private static final List<String> TOKENS =
      List.of(
          "var",
          "const",
          "function",
          "closure",
          "class",
          "enum",
          "do",
          "if",
          "else",
          "for",
          "in",
          "switch",
          "case",
          "default",
          "return",
          "break",
          "continue",
          "throw",
          "try",
          "catch",
          "finally",
          "assert",
          "at",
          "sync",
          "onleave",
          "whenever",
          "waituntil",
          "watch",
          "every",
          "timeout",
          "stopif",
          "freezeif",
          "this",
          "call",
          "new",
          "not",
          "and",
          "or",
          "bitand",
          "get",
          "set",
          "external",
          "import",
          "package",
          "nil",
          "void",
          "true",
          "false",
          "x",
          "y",
          "echo",
          "sleep",
          "detach",
          "Tag",
          "Event",
          "Object",
          "Pair",
          "List",
          "t",
          "e",
          "f",
          "g",
          "'quoted name'",
          "'+'",
          "1",
          "42",
          "0.5",
          "1e30",
          "0x2a",
          "1s",
          "20ms",
          "90deg",
          "7km",
          "1.",
          "\"text\"",
          "\"\\x00\\n\"",
          "\"\\B(2)(\"\")\"",
          "\"open",
          "(",
          ")",
          "[",
          "]",
          "{",
          "}",
          "(",
          ")",
          "{",
          "}",
          ";",
          ";",
          ";",
          ",",
          "|",
          "&",
          ":",
          "?",
          "!",
          "~",
          "=",
          "==",
          "===",
          "!=",
          "=~=",
          "<",
          "<=",
          ">",
          ">=",
          "<<",
          ">>",
          "+",
          "-",
          "*",
          "**",
          "/",
          "%",
          "^",
          "&&",
          "||",
          "+=",
          "-=",
          "++",
          "--",
          "->",
          "=>",
          ".",
          ".&",
          "&",
          "~=",
          "//",
          "/*",
          "*/",
          "//#line 3 \"f\"\n",
          "//#push 1 \"g\"\n",
          "//#pop\n",
          "\n",
          "@",
          "#",
          "$",
          "\\",
          "`",
          "\0",
          "\u00c3",
          "\u00ff",
          "\r",
          "\t");

  private final Random random;

  ProgramGenerator(long seed) {
    random = new Random(seed);
  }

  /** A soup of tokens. */
  String soup() {
    int length = 1 + random.nextInt(120);
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < length; i++) {
      text.append(TOKENS.get(random.nextInt(TOKENS.size())));
      if (random.nextInt(5) != 0) {
        text.append(' ');
      }
    }
    return text.toString();
  }

  /** The beginning of a program, cut anywhere. */
  String cut(String program) {
    return program.substring(0, random.nextInt(program.length() + 1));
  }

  /** A program from which a piece was taken out. */
  String gap(String program) {
    int from = random.nextInt(program.length() + 1);
    int to = from + random.nextInt(program.length() - from + 1);
    return program.substring(0, from) + program.substring(to);
  }

  /** A program in which a few characters were replaced by tokens. */
  String damage(String program) {
    StringBuilder text = new StringBuilder(program);
    for (int i = 0; i < 3 && !text.isEmpty(); i++) {
      int at = random.nextInt(text.length());
      text.replace(at, at + 1, TOKENS.get(random.nextInt(TOKENS.size())));
    }
    return text.toString();
  }
}
