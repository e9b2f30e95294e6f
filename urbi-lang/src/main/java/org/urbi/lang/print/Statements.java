package org.urbi.lang.print;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.Ast.Flavor;

/** Prints statements and their composition. */
final class Statements {
  private Statements() {}

  // ------------------------------------------------------------------------------ composition

  static void sequence(Ast.Sequence sequence, PrintedCode to) {
    List<Ast> statements = sequence.statements();
    List<Flavor> separators = sequence.separators();
    Flavor context = separators.isEmpty() ? Flavor.SEMICOLON : separators.get(0);
    for (int i = 0; i < statements.size(); i++) {
      part(statements.get(i), context, to);
      if (i < separators.size()) {
        Flavor separator = separators.get(i);
        boolean spaced = strength(separator) > 0;
        if (spaced) {
          to.add(' ');
        }
        to.add(separator.text());
        if (spaced || i + 1 < statements.size()) {
          to.add(' ');
        }
      }
    }
  }

  /** A statement in a sequence: one that binds looser goes between braces. */
  private static void part(Ast statement, Flavor context, PrintedCode to) {
    boolean loose =
        statement instanceof Ast.Sequence inner
            ? inner.separators().isEmpty()
                || strength(inner.separators().get(0)) <= strength(context)
            : statement instanceof Ast.Noop && strength(context) > 0;
    if (loose) {
      clause(statement, to);
    } else {
      statement.accept(to);
    }
  }

  /** How tight a separator binds. It is no {@code switch}, which would need a class of its own. */
  private static int strength(Flavor separator) {
    return separator == Flavor.AND ? 2 : separator == Flavor.PIPE ? 1 : 0;
  }

  /** The statements of a body, each on its line unless there is only one. */
  static void lines(Ast.Sequence sequence, PrintedCode to) {
    List<Ast> statements = sequence.statements();
    List<Flavor> separators = sequence.separators();
    if (statements.size() == 1) {
      part(statements.get(0), Flavor.SEMICOLON, to);
      if (!separators.isEmpty() && separators.get(0) == Flavor.COMMA) {
        to.add(',');
      }
      return;
    }
    if (!separators.isEmpty() && strength(separators.get(0)) > 0) {
      sequence(sequence, to);
      return;
    }
    for (int i = 0; i < statements.size(); i++) {
      if (i > 0) {
        to.line();
      }
      part(statements.get(i), Flavor.SEMICOLON, to);
      if (i < separators.size()) {
        to.add(separators.get(i).text());
      }
    }
  }

  static void scope(Ast.Scope scope, PrintedCode to) {
    Ast.Sequence body = scope.body();
    to.add('{');
    int begin = to.indent();
    int lines = to.lines();
    lines(body, to);
    close(begin, body.statements().size() == 1 && to.lines() == lines, to);
  }

  /** A scope that never fits on one line. */
  static void block(Ast.Scope scope, PrintedCode to) {
    to.add('{');
    int begin = to.indent();
    lines(scope.body(), to);
    close(begin, false, to);
  }

  /** What needs braces, or is a scope already. */
  static void clause(Ast body, PrintedCode to) {
    if (body instanceof Ast.Scope scope) {
      scope(scope, to);
      return;
    }
    to.add('{');
    int begin = to.indent();
    int lines = to.lines();
    body.accept(to);
    close(begin, to.lines() == lines, to);
  }

  /** Ends what was written between braces: on lines of its own, or on one with the braces. */
  private static void close(int begin, boolean single, PrintedCode to) {
    if (!to.outdent(begin)) {
      to.add('}');
    } else if (single) {
      to.join(begin);
      to.add(" }");
    } else {
      to.line();
      to.add('}');
    }
  }

  /** What a control structure governs: always between braces, on the next line. */
  static void governed(Ast body, PrintedCode to) {
    to.line();
    clause(body, to);
  }

  static void optional(String keyword, @Nullable Ast body, PrintedCode to) {
    if (body != null) {
      to.line();
      to.add(keyword);
      governed(body, to);
    }
  }

  // ------------------------------------------------------------------------------ loops

  /** The beginning of a loop, with its flavor unless that is the usual one. */
  private static void keyword(String keyword, Flavor flavor, Flavor usual, PrintedCode to) {
    to.add(keyword);
    if (flavor != usual) {
      to.add(flavor.text());
    }
  }

  static void loop(Ast.Loop loop, PrintedCode to) {
    keyword("loop", loop.flavor(), Flavor.SEMICOLON, to);
    governed(loop.body(), to);
  }

  static void loop(Ast.While loop, PrintedCode to) {
    keyword("while", loop.flavor(), Flavor.SEMICOLON, to);
    to.add(" (");
    loop.condition().accept(to);
    to.add(')');
    governed(loop.body(), to);
  }

  static void loop(Ast.For loop, PrintedCode to) {
    keyword("for", loop.flavor(), Flavor.SEMICOLON, to);
    to.add(" (");
    if (loop.init() != null) {
      loop.init().accept(to);
    }
    to.add(';');
    spaced(loop.condition(), to);
    to.add(';');
    spaced(loop.step(), to);
    to.add(')');
    governed(loop.body(), to);
  }

  private static void spaced(@Nullable Ast tree, PrintedCode to) {
    if (tree != null) {
      to.add(' ');
      tree.accept(to);
    }
  }

  static void loop(Ast.ForEach loop, PrintedCode to) {
    keyword("for", loop.flavor(), Flavor.SEMICOLON, to);
    to.add(" (");
    if (loop.name() != null) {
      to.add("var ");
      to.name(loop.name());
      to.add(" : ");
    }
    Expressions.expression(loop.range(), to);
    to.add(')');
    governed(loop.body(), to);
  }

  static void loop(Ast.Every every, PrintedCode to) {
    keyword("every", every.flavor(), Flavor.COMMA, to);
    to.add(" (");
    Expressions.expression(every.period(), to);
    to.add(')');
    governed(every.body(), to);
  }

  // ------------------------------------------------------------------------------ structures

  static void conditional(Ast.If choice, PrintedCode to) {
    to.add("if (");
    choice.condition().accept(to);
    to.add(')');
    governed(choice.thenClause(), to);
    optional("else", choice.elseClause(), to);
  }

  static void tagged(Ast.Tagged tagged, PrintedCode to) {
    Expressions.expression(tagged.tag(), to);
    to.add(": ");
    if (tagged.body() instanceof Ast.Noop || tagged.body() instanceof Ast.Sequence) {
      clause(tagged.body(), to);
    } else {
      tagged.body().accept(to);
    }
  }

  static void timeout(Ast.Timeout timeout, PrintedCode to) {
    to.add("timeout (");
    Expressions.expression(timeout.duration(), to);
    to.add(')');
    governed(timeout.body(), to);
  }

  /** A statement that consists of a word and a value, if there is one. */
  static void leave(String keyword, @Nullable Ast value, PrintedCode to) {
    to.add(keyword);
    if (value != null) {
      to.add(' ');
      Expressions.expression(value, to);
    }
  }

  static void doBlock(Ast.Do block, PrintedCode to) {
    to.add("do");
    if (block.target() != null) {
      to.add(" (");
      Expressions.expression(block.target(), to);
      to.add(')');
    }
    to.line();
    scope(block.body(), to);
  }

  static void choice(Ast.Switch choice, PrintedCode to) {
    to.add("switch (");
    choice.value().accept(to);
    to.add(')');
    to.line();
    to.add('{');
    for (Ast.Case one : choice.cases()) {
      to.line();
      // Only this line is further to the right, not those of a pattern that has more.
      to.add("  case ");
      Expressions.expression(one.pattern(), to);
      guard(one.guard(), to);
      alternative(one.body(), to);
    }
    if (choice.defaultClause() != null) {
      to.line();
      to.add("  default");
      alternative(choice.defaultClause(), to);
    }
    to.line();
    to.add('}');
  }

  private static void alternative(Ast.Sequence body, PrintedCode to) {
    to.add(':');
    to.more();
    int begin = to.indent();
    lines(body, to);
    to.outdent(begin);
    to.less();
  }

  static void guard(@Nullable Ast guard, PrintedCode to) {
    if (guard != null) {
      to.add(" if ");
      Expressions.expression(guard, to);
    }
  }

  static void attempt(Ast.Try attempt, PrintedCode to) {
    to.add("try");
    to.line();
    scope(attempt.body(), to);
    for (Ast.Catch one : attempt.catches()) {
      to.line();
      to.add("catch");
      if (one.pattern() != null) {
        to.add(" (");
        Expressions.expression(one.pattern(), to);
        guard(one.guard(), to);
        to.add(')');
      }
      to.line();
      scope(one.body(), to);
    }
    optional("else", attempt.elseClause(), to);
    optional("finally", attempt.finallyClause(), to);
  }

  static void claim(Ast.Assert claim, PrintedCode to) {
    if (!claim.block()) {
      to.add("assert(");
      Expressions.expression(claim.claims().get(0), to);
      to.add(')');
      return;
    }
    to.add("assert");
    to.line();
    to.add('{');
    to.more();
    for (Ast one : claim.claims()) {
      to.line();
      one.accept(to);
      to.add(';');
    }
    to.less();
    to.line();
    to.add('}');
  }
}
