package org.urbi.tests;

/**
 * Makes statements and expressions, too, of lists, dictionaries, strings, bits, constants, slots
 * that are counted up, {@code switch} over constants and {@code try} with all of its clauses.
 */
abstract class ContainerCodeGenerator extends InnerCodeGenerator {
  /** What such code uses. */
  static final String CONTAINER_PRELUDE =
      """
      var items = nil|; var table = nil|; var word = nil|;
      function fill { items = [1, 2, 3, "x", 0.5]| table = ["a" => 1, "b" => 2]| word = "abcab"| o.x = 1| o.y = 2| 0 }|;
      fill;
      """;

  ContainerCodeGenerator(long seed) {
    super(seed);
  }

  /** A variable that counts no turns, so that it may be assigned. */
  abstract String target();

  /** A loop's body, in which the variable exists. */
  abstract String turns(String name);

  /** Most of what fails is caught, or little of a function would ever be executed. */
  String containerStatement() {
    String statement = containerCode();
    return chance(60) ? tried("{ " + statement + " }") : statement;
  }

  private String containerCode() {
    return switch (random.nextInt(22)) {
      case 0, 1 -> element() + " = " + expression(2);
      case 2, 3 -> element() + one(" += ", " -= ", " *= ") + expression(1);
      case 4 -> element() + one("++", "--");
      case 5 -> "{ if (items.size > 6) items = [1]; items << " + expression(2) + " }";
      case 6 -> "echo(" + one("items", "table.size", "items.size", "word", element()) + ")";
      case 7, 8 -> "o." + one("x", "y") + one(" += ", " -= ", " *= ") + expression(2);
      case 9 -> "o." + one("x", "y") + one("++", "--");
      case 10 -> constant();
      case 11, 12 -> each("items", "[1, \"x\", [2]]", "table.keys.sort", "[" + variable() + "]");
      case 13, 14 -> choice();
      case 15, 16 -> attempt();
      case 17 -> "items = [" + expression(1) + ", 1, \"x\"]";
      case 18 -> target() + " = " + one("items", "table", "word", "[1, 2]", "[=>]");
      case 19 -> "{ if (word.size > 40) word = \"ab\" | word = \"w\" + " + expression(1) + " }";
      case 20 -> "assert { " + expression(1) + one(" == ", " < ", " != ") + expression(1) + " }";
      default ->
          "do (o) { x = " + expression(1) + one("", "| y = x", "| " + target() + " = x") + " }";
    };
  }

  String containerExpression(int depth) {
    return switch (random.nextInt(19)) {
      case 0, 1, 2, 3 -> element();
      case 4 -> one("items", "table", "word", "[1, 2]", variable()) + ".size";
      case 5 -> "(\"s\" + " + expression(depth) + ")";
      case 6, 7 ->
          "("
              + expression(depth)
              + one(" << ", " >> ", " ^ ", " bitand ", " bitor ")
              + expression(depth)
              + ")";
      case 8 -> "word[" + index() + "]";
      case 9 -> "(\"%s-%s\" % [" + expression(depth) + ", 1])";
      case 10 ->
          "(["
              + expression(depth)
              + ", 1]"
              + one(" == ", " + ", " != ")
              + "["
              + variable()
              + ", 1])";
      case 11 -> "(" + expression(depth) + one(" in ", " not in ") + "items)";
      case 12 ->
          "[" + expression(depth) + ", " + expression(depth) + "][" + one("0", "1", "-1") + "]";
      case 13 -> one("(- ", "(!", "(+ ") + expression(depth) + ")";
      case 14 -> "(" + element() + " = " + expression(depth) + ")";
      case 15 -> element() + one("++", "--");
      case 16 -> "o.x" + one("++", "--");
      case 17 -> "(" + expression(depth) + one(" && ", " || ") + variable() + ")";
      default -> "(" + expression(depth) + ").asString";
    };
  }

  private String element() {
    return switch (random.nextInt(8)) {
      case 0 -> "table[" + one("\"a\"", "\"b\"", "\"c\"", variable()) + "]";
      case 1 -> variable() + "[" + index() + "]";
      default -> "items[" + index() + "]";
    };
  }

  private String index() {
    return chance(90) ? one("0", "1", "2", "-1") : one(variable(), "9", "0.5", "o.x", "\"a\"");
  }

  private String constant() {
    String name = "k" + names++;
    String change = name + one(" = 1", " += " + expression(1), "++", " -= 1");
    return "{ const var "
        + name
        + " = "
        + expression(1)
        + "| "
        + tried("{ " + change + " }")
        + "| echo("
        + name
        + ") }";
  }

  /** A loop over one of these. */
  String each(String... all) {
    String element = "v" + names++;
    return "for" + one("", "|") + " (var " + element + " : " + one(all) + ") " + turns(element);
  }

  private String choice() {
    return "switch ("
        + expression(1)
        + ") { case 1: "
        + inside(1)
        + "; case 2: "
        + inside(1)
        + "; case \"x\": "
        + inside(1)
        + one("; case nil: echo(0)", "; case 0.5: echo(1)", "")
        + "; default: "
        + inside(1)
        + " }";
  }

  private String attempt() {
    String caught = "e" + names++;
    return "try "
        + inside(2)
        + " catch (var "
        + caught
        + one("", " if o.x < 2", " if " + caught + " == 1")
        + ") "
        + inside(1)
        + one("", " else " + inside(1))
        + one("", " finally " + inside(1));
  }
}
