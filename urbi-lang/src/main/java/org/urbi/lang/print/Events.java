package org.urbi.lang.print;

import org.urbi.lang.ast.Ast;

/** Prints event-based constructs. */
final class Events {
  private Events() {}

  static String at(Ast.At at) {
    String keyword = at.sync() ? "at sync " : "at ";
    return keyword
        + condition(at.condition())
        + "\n"
        + Statements.clause(at.body())
        + Statements.optional("onleave", at.onLeave());
  }

  static String whenever(Ast.Whenever whenever) {
    return "whenever "
        + condition(whenever.condition())
        + "\n"
        + Statements.clause(whenever.body())
        + Statements.optional("else", whenever.elseClause());
  }

  static String condition(Ast.Condition condition) {
    String text =
        switch (condition) {
          case Ast.WhenTrue state -> Expressions.expression(state.expression());
          case Ast.WhenEmitted event ->
              Expressions.expression(event.event())
                  + "?"
                  + Expressions.arguments(event.patterns())
                  + (event.guard() == null ? "" : " if " + Expressions.expression(event.guard()));
        };
    String duration =
        condition.duration() == null ? "" : " ~ " + Expressions.expression(condition.duration());
    return "(" + text + duration + ")";
  }

  static String lasting(Ast.Emit emit, Ast duration) {
    return Expressions.emission(emit) + " ~ " + Expressions.expression(duration);
  }
}
