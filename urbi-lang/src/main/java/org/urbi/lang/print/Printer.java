package org.urbi.lang.print;

import org.urbi.lang.ast.Ast;

/**
 * Shows code as the interpreter does (manual, "Functions" and "Assertions"): operators are
 * messages, a body of one statement fits on its line, a longer one has a line for each.
 *
 * <p>What is printed can be parsed, and prints the same again.
 */
public final class Printer {
  private Printer() {}

  /** The code of any tree; lines are separated by line feeds, the last has none. */
  public static String print(Ast tree) {
    var code = new PrintedCode();
    tree.accept(code);
    return code.toString();
  }

  /** A function without its formal arguments and its braces. */
  public static String printBody(Ast.Scope scope) {
    var code = new PrintedCode();
    Statements.lines(scope.body(), code);
    return code.toString();
  }
}
