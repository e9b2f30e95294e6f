package org.urbi.lang.print;

import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;

/** Prints event-based constructs. */
final class Events {
  private Events() {}

  static void at(Ast.At at, PrintedCode to) {
    to.add(at.sync() ? "at sync " : "at ");
    condition(at.condition(), to);
    Statements.governed(at.body(), to);
    Statements.optional("onleave", at.onLeave(), to);
  }

  static void whenever(Ast.Whenever whenever, PrintedCode to) {
    to.add("whenever ");
    condition(whenever.condition(), to);
    Statements.governed(whenever.body(), to);
    Statements.optional("else", whenever.elseClause(), to);
  }

  static void waitUntil(Ast.WaitUntil wait, PrintedCode to) {
    to.add("waituntil ");
    condition(wait.condition(), to);
  }

  /** A statement that is run as long as there is a condition: its keyword says what that does. */
  static void conditional(String keyword, Ast.Condition condition, Ast body, PrintedCode to) {
    to.add(keyword);
    condition(condition, to);
    Statements.governed(body, to);
  }

  private static void condition(Ast.Condition condition, PrintedCode to) {
    to.add('(');
    if (condition instanceof Ast.WhenTrue state) {
      Expressions.expression(state.expression(), to);
    } else if (condition instanceof Ast.WhenEmitted event) {
      Expressions.expression(event.event(), to);
      to.add('?');
      Expressions.arguments(event.patterns(), to);
      Statements.guard(event.guard(), to);
    }
    lasting(condition.duration(), to);
    to.add(')');
  }

  static void emission(Ast.Emit emit, PrintedCode to) {
    Expressions.primary(emit.event(), to);
    to.add('!');
    Expressions.arguments(emit.arguments(), to);
    lasting(emit.duration(), to);
  }

  private static void lasting(@Nullable Ast duration, PrintedCode to) {
    if (duration != null) {
      to.add(" ~ ");
      Expressions.expression(duration, to);
    }
  }
}
