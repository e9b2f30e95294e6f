package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.tests.KernelSession.BackEnd;
import org.urbi.tests.KernelSession.Console;
import org.urbi.tests.KernelSession.InputMode;

/** Excessive input yields a value or an error, and the kernel continues. */
class RobustnessTest {
  private static final int DEPTH = 100_000;
  private static final int MEGA = 1_000_000;

  @ParameterizedTest
  @EnumSource
  void runawayRecursionIsCaught(BackEnd backEnd) {
    says(
        "*** surfaced",
        backEnd,
        """
        function dive(n) { dive(n + 1) + 1 }|;
        try { dive(0) } catch (var e) { echo("surfaced") };
        """);
  }

  @ParameterizedTest
  @EnumSource
  void uncaughtRunawayRecursionIsAnError(BackEnd backEnd) {
    says(":error] !!! ", backEnd, "function dive(n) { dive(n + 1) + 1 }|;\ndive(0);\n");
  }

  @ParameterizedTest
  @EnumSource
  void runawayMutualRecursionOfMethodsIsCaught(BackEnd backEnd) {
    says(
        "*** surfaced",
        backEnd,
        """
        class Diver { function down() { deeper; {} }; function deeper() { down; {} } }|;
        try { Diver.new.down } catch { echo("surfaced") };
        """);
  }

  @ParameterizedTest
  @EnumSource
  void runawayRecursionInTheBackgroundEndsItsJobOnly(BackEnd backEnd) {
    says(
        "*** still here",
        backEnd,
        """
        function dive(n) { dive(n + 1) + 1 }|;
        dive(0),
        sleep(1s);
        echo("still here");
        """);
  }

  @ParameterizedTest
  @EnumSource
  void deepParentheses(BackEnd backEnd) {
    goesOnAfter(backEnd, "(".repeat(DEPTH) + "1" + ")".repeat(DEPTH) + ";\n");
  }

  @ParameterizedTest
  @EnumSource
  void deepBrackets(BackEnd backEnd) {
    goesOnAfter(backEnd, "[".repeat(DEPTH) + "1" + "]".repeat(DEPTH) + ";\n");
  }

  @ParameterizedTest
  @EnumSource
  void deepScopes(BackEnd backEnd) {
    goesOnAfter(backEnd, "{".repeat(DEPTH) + "1" + "}".repeat(DEPTH) + ";\n");
  }

  @ParameterizedTest
  @EnumSource
  void aLongChainOfOperators(BackEnd backEnd) {
    goesOnAfter(backEnd, "1" + "+1".repeat(DEPTH) + ";\n");
  }

  @ParameterizedTest
  @EnumSource
  void aLongChainOfMessages(BackEnd backEnd) {
    goesOnAfter(backEnd, "1" + ".sqr".repeat(DEPTH) + ";\n");
  }

  @ParameterizedTest
  @EnumSource
  void manyClosingBraces(BackEnd backEnd) {
    goesOnAfter(backEnd, "}".repeat(10_000) + ";\n");
  }

  @ParameterizedTest
  @EnumSource
  void nulByte(BackEnd backEnd) {
    goesOnAfter(backEnd, "\0;\n");
    says("] 3", backEnd, "\"a\0b\".size;\n");
  }

  @ParameterizedTest
  @EnumSource
  void invalidUtf8(BackEnd backEnd) {
    says("invalid character: `\\xff'", backEnd, "\u00ff\u00fe\u0080;\n");
    goesOnAfter(backEnd, "\u00c3;\n\u00ff;\n");
    says("] 3", backEnd, "\"\u00ff\u00c3\u0080\".size;\n");
  }

  @ParameterizedTest
  @EnumSource
  void tenMegabyteLine(BackEnd backEnd) {
    says("] true", backEnd, "\"" + "a".repeat(10 * MEGA) + "\".size == 10000000;\n");
    goesOnAfter(backEnd, " ".repeat(10 * MEGA) + ";\n");
    goesOnAfter(backEnd, "/*" + "*".repeat(10 * MEGA) + "*/;\n");
  }

  @ParameterizedTest
  @EnumSource
  void fiftyMegabyteString(BackEnd backEnd) {
    says(
        "] true",
        backEnd,
        """
        var big = "0123456789" * 5000000|;
        big.size == 50000000;
        """);
  }

  @ParameterizedTest
  @EnumSource
  void unfinishedInputEndsWithItsConnection(BackEnd backEnd) throws Exception {
    try (KernelSession session = KernelSession.inVirtualTime(backEnd)) {
      for (String start : new String[] {"(", "{", "[", "\"", "/*", "function f(", "1 +", "'"}) {
        Console console = session.connect();
        console.send(start);
        console.end();
        console.whenClosed().get();
      }
      Console next = session.connect();
      next.send("1+1;\n");
      next.receives("] 2\n").get();
    }
  }

  /** Whatever comes of the program, the same console then adds two numbers. */
  private static void goesOnAfter(BackEnd backEnd, String program) {
    says("] 1234567", backEnd, program + "1234560+7;\n");
  }

  private static void says(String what, BackEnd backEnd, String program) {
    String output = KernelSession.run(backEnd, InputMode.WHOLE, program);
    assertTrue(output.contains(what), () -> "no “" + what + "” in:\n" + shortened(output));
  }

  private static String shortened(String text) {
    return text.length() < 2_000 ? text : text.substring(0, 2_000) + "…";
  }
}
