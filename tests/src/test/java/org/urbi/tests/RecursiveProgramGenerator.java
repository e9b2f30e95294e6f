package org.urbi.tests;

import java.util.List;

/**
 * Makes programs of functions that call themselves, and fail, catch, stop, wait and hand out code
 * in between; the same ones from the same seed. All of them end.
 */
final class RecursiveProgramGenerator extends InnerCodeGenerator {
  private static final int FUNCTIONS = 3;

  /** So a function calls itself 80 times at most. */
  private static final int MOST_CALLS = 3;

  private static final String PRELUDE =
      """
      var o = Object.new|; var o.x = 1|; var log = []|; var t = Tag.new|; var saved = nil|;
      function o.keep { lobby.saved = call | 1 }|; function o.lazy { call.evalArgAt(0) }|;
      function o.wait { sleep(1ms) | x += 1 }|; var plus = Float.getSlotValue("+")|;
      """;

  private String name = "";
  private int calls;

  private RecursiveProgramGenerator(long seed) {
    super(seed);
  }

  static String program(long seed) {
    return new RecursiveProgramGenerator(seed).program();
  }

  private String program() {
    text.append(BOUNDED).append(PRELUDE).append(INNER_PRELUDE);
    for (int i = 0; i < FUNCTIONS; i++) {
      name = "r" + i;
      function();
    }
    for (int i = 0; i < 20; i++) {
      name = "r" + random.nextInt(FUNCTIONS);
      text.append(topLevel()).append('\n');
    }
    return text.append("log;\n").toString();
  }

  private String call() {
    return name
        + "("
        + one("1", "2", "0.5", "1", "\"s\"", "nil", "[1]")
        + ", "
        + one("0", "1", "3", "4")
        + ")";
  }

  private String topLevel() {
    return switch (random.nextInt(13)) {
      case 0 ->
          "Float.'+' = function (n) { lobby.getSlotValue(\"plus\").apply([this, n]) * 2 }|; "
              + call()
              + ";";
      case 1 -> "Float.'+' = lobby.getSlotValue(\"plus\")|; " + call() + ";";
      case 2 -> call() + ", " + call() + ", sleep(20ms)|; log;";
      case 3 -> call() + " & " + call() + ";";
      case 4 -> "t: " + call() + ", sleep(" + random.nextInt(4) + "ms)|; t.stop|;";
      case 5 -> "t: " + call() + ", t.freeze|; sleep(2ms)|; t.unfreeze|; sleep(9ms)|;";
      case 6 -> "try { " + call() + " } catch (var e) { echo(e); echo(e.backtrace) };";
      case 7 -> "saved.evalArgAt(0);";
      case 8 ->
          "{ var old = getSlotValue(\""
              + name
              + "\"); lobby."
              + name
              + " = function (a, n) { [a, n] }; echo("
              + call()
              + "); lobby."
              + name
              + " = old }|; "
              + call()
              + ";";
      case 9 -> "log; log = []|; t: { " + call() + " }; o.x;";
      default -> call() + ";";
    };
  }

  private void function() {
    names = 0;
    variables.clear();
    variables.addAll(List.of("a", "a", "n"));
    calls = MOST_CALLS;
    text.append("function ").append(name).append("(a, n) {\n  if (n < 1) return ");
    text.append(expression(1)).append(";\n");
    calls = 0;
    block(2 + random.nextInt(4));
    text.append("  ").append(expression(3)).append("\n}|;\n");
  }

  /**
   * A level is as deep as the calls that are left, so that what is rare happens at some of them.
   */
  private String rarely() {
    return "if (n == "
        + one("1", "2", "3")
        + ") "
        + one(
            "o.missing",
            "throw a",
            "t.stop(a)",
            "o.wait",
            "o.keep(a = " + expression(1) + ")",
            "a = o.lazy(" + variable() + " + 1)",
            "return a",
            "nil.missing",
            "[1, 2].each(closure (y) { if (y == 2) return a; log << y })");
  }

  @Override
  String statement() {
    return switch (random.nextInt(nested < 2 ? 15 : 9)) {
      case 0, 1 -> declaration(2);
      case 2 -> "a = " + expression(3);
      case 3 -> "a += " + expression(2);
      case 4 -> "o.x = " + expression(2);
      case 5 -> "o.x += 1";
      case 6 -> "log << " + expression(1);
      case 7, 8 -> rarely();
      case 9 -> "if (" + condition() + ") " + inside(2);
      case 10 -> "if (" + condition() + ") " + inside(1) + " else " + inside(2);
      case 11 ->
          "try "
              + inside(2)
              + " catch (var e"
              + names
              + ") { log << \"c\" + n; a = "
              + expression(2)
              + " }";
      case 12 -> "try " + inside(2) + " finally { log << n }";
      case 13 -> "{ var w" + names + " = " + expression(2) + "; a = w" + names++ + " }";
      default -> innerCode();
    };
  }

  private String condition() {
    return expression(1) + one(" < ", " == ", " != ", " >= ") + expression(1);
  }

  @Override
  String expression(int depth) {
    if (depth == 0 || chance(25)) {
      return chance(60) ? variable() : one("0", "1", "2", "0.5", "nan", "\"s\"", "nil", "o.x");
    }
    if (chance(40) && calls < MOST_CALLS) {
      calls++;
      return name + "(" + expression(depth - 1) + ", n - " + one("1", "1", "2") + ")";
    }
    return "("
        + expression(depth - 1)
        + one(" + ", " - ", " * ", " + ")
        + expression(depth - 1)
        + ")";
  }
}
