package org.urbi.lang.print;

import org.urbi.lang.ast.Ast;

/** Code as the interpreter shows it. */
public final class Printer {
  private Printer() {}

  /** One tree. */
  public static String print(Ast ast) {
    return ast.span().text();
  }
}
