package org.urbi.tests;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** What the makers of programs of functions have in common: choices, blocks and local variables. */
abstract class FunctionGenerator {
  /** Programs that add a text or a list to itself, again and again, fill any memory. */
  static final String BOUNDED =
      """
      for| (var p : [String, List]) do (p) { var joined = getSlotValue("+"); var repeated = getSlotValue("*");
        '+' = function (other) { if (size < 99) joined(other) else "long" };
        '*' = function (times) { if (size < 99 && times < 99) repeated(times) else "long" } }|;
      """;

  final Random random;
  final StringBuilder text = new StringBuilder();

  /** The local variables that can be used; those that are used more often are there twice. */
  final List<String> variables = new ArrayList<>();

  /** How many names have been made in the function. */
  int names;

  /** How many blocks are around what is being made. */
  int nested;

  FunctionGenerator(long seed) {
    random = new Random(seed);
  }

  abstract String statement();

  /**
   * An expression.
   *
   * @param depth how many expressions are in each other at most
   */
  abstract String expression(int depth);

  String one(String... choices) {
    return choices[random.nextInt(choices.length)];
  }

  boolean chance(int percent) {
    return random.nextInt(100) < percent;
  }

  /** A variable; where there is no local one, a slot of the object that all programs have. */
  String variable() {
    return variables.isEmpty() ? "o.x" : variables.get(random.nextInt(variables.size()));
  }

  /** Declares one more variable. */
  String declaration(int depth) {
    String value = expression(depth);
    String fresh = "v" + names++;
    variables.add(fresh);
    return "var " + fresh + " = " + value;
  }

  /** Adds statements to the text. */
  void block(int statements) {
    int before = variables.size();
    for (int i = 0; i < statements; i++) {
      text.append("  ").append(statement()).append(one(";", "|", "|")).append('\n');
    }
    while (variables.size() > before) {
      variables.removeLast();
    }
  }

  /** A statement whose exceptions are caught, and told. */
  String tried(String block) {
    String caught = "e" + names++;
    return "try " + block + " catch (var " + caught + ") { echo(" + caught + ") }";
  }

  /** A block, which is not in the text yet. */
  String inside(int statements) {
    int begin = text.length();
    nested++;
    block(statements);
    nested--;
    String inner = text.substring(begin);
    text.setLength(begin);
    return "{\n" + inner + "  }";
  }
}
