package org.urbi.tests;

import java.util.List;

/**
 * Makes programs of functions that compute, loop, call each other, fail and let others run; the
 * same ones from the same seed. All of them end.
 */
final class NumericProgramGenerator extends ContainerCodeGenerator {
  private static final int FUNCTIONS = 6;

  /** What every program begins with. */
  private static final String PRELUDE =
      """
      var o = Object.new|; var o.x = 1|; var o.y = 2|; var saved = nil|; var global = 3|;
      function o.get(n) { x + n }|;
      function o.set(n) { x = n | this }|;
      class P { var v = 5; function init(n) { v = n }; function '+'(other) { P.new(v + other) };
        function '<'(other) { v < other }; function asString() { "P" + v } }|;
      function lazy { call.evalArgAt(0) }|;
      function twice { call.evalArgAt(0) + call.evalArgAt(0) }|;
      function keep { saved = call | 0 }|;
      function later { var c = call | detach({ sleep(3ms) | c.evalArgAt(0) }) | 0 }|;
      function same(n) { n }|;
      function down(n) { if (n < 1) 0 else 1 + down(n - 1) }|;
      function many(n, args[]) { n + args.size }|;
      function preset(n, m = 7) { n * m }|;
      var plus = Float.getSlotValue("+")|; var less = Float.getSlotValue("<")|;
      var item = List.getSlotValue("[]")|;
      """;

  private static final List<String> LITERALS =
      List.of("0", "1", "2", "3", "0.5", "-1", "1e300", "7", "100", "inf", "nan");

  private int callable;

  /** Whether the function has only what is compiled. */
  private boolean plain;

  /** Whether the only variables of the function are those of code that is not compiled. */
  private boolean bare;

  /** Which functions have no parameters. */
  private final boolean[] parameterless = new boolean[FUNCTIONS];

  private NumericProgramGenerator(long seed) {
    super(seed);
  }

  static String program(long seed) {
    return new NumericProgramGenerator(seed).program();
  }

  private String program() {
    if (chance(60)) {
      text.append(BOUNDED);
    }
    text.append(PRELUDE).append(INNER_PRELUDE).append(CONTAINER_PRELUDE);
    for (callable = 0; callable < FUNCTIONS; callable++) {
      function();
    }
    for (int i = 0; i < 25; i++) {
      text.append(chance(40) ? "fill|; " : "").append(topLevel()).append('\n');
    }
    return text.toString();
  }

  // ------------------------------------------------------------------ the top level

  private String topLevel() {
    String call = call(random.nextInt(FUNCTIONS));
    return switch (random.nextInt(22)) {
      case 0 ->
          "Float.'+' = function(n) { lobby.getSlotValue(\"plus\").apply([this, n]) * 2 }|; "
              + call
              + ";";
      case 1 ->
          "Float.'<' = function(n) { n > this }|; "
              + call
              + "; Float.'<' = lobby.getSlotValue(\"less\")|;";
      case 2 -> "Float.'+' = lobby.getSlotValue(\"plus\")|; " + call + ";";
      case 3 -> "var Float.more" + names++ + " = 1|; " + call + ";";
      case 4 -> call + ", " + call(random.nextInt(FUNCTIONS)) + ", sleep(20ms);";
      case 5 -> call + " & " + call(random.nextInt(FUNCTIONS)) + ";";
      case 6 ->
          "var t = Tag.new|; t: "
              + call
              + ", sleep("
              + random.nextInt(4)
              + "ms)|; t.stop|;"
              + " removeLocalSlot(\"t\")|;";
      case 7 -> "for| (var i : 3) { global += i }| global;";
      case 8 -> "{ var n = 0; while (n < 5) { n++; global = n }; n };";
      case 9 -> "saved.evalArgAt(0);";
      case 10 ->
          "var t = Tag.new|; t: "
              + call
              + ", t.freeze|; sleep(2ms)|; t.unfreeze|; sleep(9ms)|;"
              + " removeLocalSlot(\"t\")|;";
      case 11 -> "try { " + call + " } catch (var e) { echo(e) };";
      case 12, 13 -> ("again" + random.nextInt(FUNCTIONS) + "(); ").repeat(3);
      case 14 -> "for| (12) again" + random.nextInt(FUNCTIONS) + "();";
      case 15 -> "o.get = function (n) { " + one("n", "x - n", "this.x + n") + " }|; " + call + ";";
      case 16 ->
          "List.'[]' = function(n) { lobby.getSlotValue(\"item\").apply([this, n]) + 1 }|; "
              + call
              + "; List.'[]' = lobby.getSlotValue(\"item\")|;";
      case 17 ->
          "o.setProperty(\"x\", \"constant\", true)|; "
              + call
              + "; o.setProperty(\"x\", \"constant\", false)|;";
      case 18 ->
          "var h = Tag.new|; h: at (o.x > 3) echo(\"high\") onleave echo(\"low\"); "
              + call
              + "; sleep(5ms)|; h.stop|; removeLocalSlot(\"h\")|;";
      default -> call + ";";
    };
  }

  private String call(int function) {
    String arguments = parameterless[function] ? "" : argument() + ", " + argument();
    return "f" + function + "(" + arguments + ")";
  }

  private String argument() {
    return chance(88)
        ? one("0", "1", "2", "5", "0.5", "-3")
        : one("\"s\"", "nil", "P.new(2)", "[1]", "o");
  }

  // ------------------------------------------------------------------ statements

  private void function() {
    names = 0;
    plain = chance(45);
    bare = !plain && chance(60);
    parameterless[callable] = bare && chance(50);
    variables.clear();
    if (!bare) {
      variables.addAll(List.of("a", "b"));
    }
    text.append("function f").append(callable);
    text.append(parameterless[callable] ? "() {\n" : "(a, b) {\n");
    block(bare ? 1 + random.nextInt(3) : 3 + random.nextInt(5));
    text.append("  ").append(bare ? "o.x" : expression(2)).append("\n}|;\n");
    // Compiled code enters compiled functions in another way than the top level does.
    text.append("function again").append(callable).append("() { ");
    text.append(call(callable)).append("; ").append(call(callable)).append(" }|;\n");
  }

  @Override
  String target() {
    for (int tries = 0; tries < 20; tries++) {
      String name = variable();
      if (!name.startsWith("i")) {
        return name;
      }
    }
    return "o.x";
  }

  @Override
  String statement() {
    if (bare && !isInner()) {
      return bareStatement();
    }
    if (nested < 3 && chance(30)) {
      return compound();
    }
    if (chance(20)) {
      return containerStatement();
    }
    String name = target();
    return switch (random.nextInt(plain ? 21 : 22)) {
      case 0, 1, 2 -> declaration(3);
      case 3, 4 -> name + " = " + expression(3);
      case 5, 6 -> name + one(" += ", " -= ", " += ", " *= ") + expression(2);
      case 7, 8 -> name + one("++", "--");
      case 9 -> "echo(" + expression(2) + ")";
      case 10 -> "echo(" + variable() + " === " + variable() + ")";
      case 11 -> "o.x = " + expression(2);
      case 12 -> "echo(" + variable() + " + 1)";
      case 13 -> "keep(" + variable() + one("", " + 1", " = 9") + ")";
      case 14 -> "later(" + name + " = " + expression(1) + ")";
      case 15 -> "sleep(" + one("1ms", "2ms", "5ms") + ")";
      case 16 -> loops > 0 ? one("break", "continue") : "echo(saved.evalArgAt(0))";
      case 17 -> chance(30) ? "return " + expression(2) : "echo(this === lobby)";
      case 18 -> name + " = " + variable() + " | echo(" + name + " === " + variable() + ")";
      case 19 ->
          "if (!"
              + name
              + ".hasLocalSlot(\"tag\")) "
              + name
              + ".setSlot(\"tag\", "
              + expression(1)
              + ")";
      case 20 -> "global += " + expression(1);
      default ->
          "var c"
              + names
              + " = closure(n) { "
              + name
              + " = n + "
              + variable()
              + " } | c"
              + names++
              + "("
              + expression(1)
              + ")";
    };
  }

  /** Of a function which has no variables but those of code that is not compiled. */
  private String bareStatement() {
    return switch (random.nextInt(nested < 2 ? 12 : 9)) {
      case 0 -> "global += " + one("1", "o.x", "same(o.x)");
      case 1 -> "o.x = " + one("1", "3", "o.y", "o.get(1)");
      case 2 -> "sleep(1ms)";
      case 9 -> "if (o.x " + one("<", "==", ">") + " 2) " + inside(1) + " else " + inside(1);
      case 10 -> "for" + one("", "|") + " (" + one("2", "12") + ") " + inside(1);
      case 11 -> "try " + inside(1) + " finally " + inside(1);
      default -> innerCode();
    };
  }

  private String compound() {
    return switch (random.nextInt(plain ? 6 : 11)) {
      case 0, 1 -> "if (" + condition() + ") " + inside(2);
      case 2 -> "if (" + condition() + ") " + inside(1) + " else " + inside(2);
      case 3 -> loop("while" + one("", "|"), "i");
      case 4 -> {
        String i = "i" + names++;
        yield "for"
            + one("", "|")
            + " (var "
            + i
            + " = 0; "
            + i
            + " < "
            + (1 + random.nextInt(4))
            + "; "
            + i
            + one("++", " += 1")
            + ") "
            + turns(i);
      }
      case 5 -> each("3", "2", "[1, \"x\", 2]", "2.5");
      case 6 -> tried(inside(2));
      case 7 -> "try " + inside(2) + " finally " + inside(1);
      case 8, 9 -> innerCode();
      default -> inside(2);
    };
  }

  private String loop(String keyword, String prefix) {
    String i = prefix + names++;
    variables.add(i);
    loops++;
    String body = inside(2);
    loops--;
    variables.removeLast();
    return "{ var "
        + i
        + " = 0| "
        + keyword
        + " ("
        + i
        + " < "
        + (1 + random.nextInt(4))
        + ") { "
        + i
        + one("++", " += 1")
        + "| "
        + body.substring(1)
        + " }";
  }

  @Override
  String turns(String name) {
    variables.add(name);
    loops++;
    String body = inside(2);
    loops--;
    variables.removeLast();
    return body;
  }

  // ------------------------------------------------------------------ expressions

  private String condition() {
    return switch (random.nextInt(8)) {
      case 0 ->
          expression(1) + " < " + expression(1) + one(" && ", " || ") + expression(1) + " > 2";
      case 1 -> "!(" + expression(1) + " == " + expression(1) + ")";
      case 2 -> variable();
      case 3 -> variable() + " === " + variable();
      default -> expression(2) + one(" < ", " <= ", " > ", " >= ", " == ", " != ") + expression(2);
    };
  }

  @Override
  String expression(int depth) {
    if (depth == 0 || chance(25)) {
      return chance(65) ? variable() : LITERALS.get(random.nextInt(LITERALS.size()));
    }
    if (chance(8)) {
      return containerExpression(depth - 1);
    }
    return switch (random.nextInt(22)) {
      case 0, 1, 2, 3, 4, 5, 6 ->
          "("
              + expression(depth - 1)
              + one(
                  " + ", " - ", " * ", " + ", " - ", chance(40) ? one(" / ", " % ", " ** ") : " * ")
              + expression(depth - 1)
              + ")";
      case 7 ->
          "("
              + expression(depth - 1)
              + one(" < ", " == ", " >= ", " != ")
              + expression(depth - 1)
              + ")";
      case 8 -> "same(" + expression(depth - 1) + ")";
      case 9 -> "o.get(" + expression(depth - 1) + ")";
      case 10 -> "o." + one("x", "y", "set(" + variable() + ").x");
      case 11 ->
          "lazy("
              + (chance(50) ? expression(depth - 1) : target() + " = " + expression(depth - 1))
              + ")";
      case 12 -> "twice(" + one(target() + "++", variable(), target() + " += 1") + ")";
      case 13 -> "(" + target() + " = " + expression(depth - 1) + ")";
      case 14 -> target() + one("++", "--");
      case 15 ->
          callable > 0 && loops == 0 && chance(40) ? call(random.nextInt(callable)) : "down(3)";
      case 16 -> "many(" + expression(depth - 1) + one("", ", 1", ", 1, " + variable()) + ")";
      case 17 -> "preset(" + variable() + one("", ", " + variable()) + ")";
      case 18 -> "global";
      case 19 ->
          chance(75)
              ? variable()
              : one(
                  "\"s\"",
                  "nil",
                  "P.new(" + variable() + ")",
                  "void",
                  "[" + variable() + "]",
                  "missing");
      case 20 -> "{ var w" + names + " = " + expression(depth - 1) + "| w" + names++ + " + 1 }";
      default ->
          "{ if (" + condition() + ") " + variable() + " else " + expression(depth - 1) + " }";
    };
  }
}
