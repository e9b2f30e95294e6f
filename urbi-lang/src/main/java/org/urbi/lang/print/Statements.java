package org.urbi.lang.print;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.Ast.Flavor;

/** Prints statements and their composition. */
final class Statements {
  private Statements() {}

  static String statement(Ast tree) {
    return NodePrinters.of(tree).text().get();
  }

  static String conditional(Ast.If choice) {
    return "if ("
        + statement(choice.condition())
        + ")\n"
        + clause(choice.thenClause())
        + optional("else", choice.elseClause());
  }

  static String conditional(String keyword, Ast.Condition condition, Ast body) {
    return keyword + " " + Events.condition(condition) + "\n" + clause(body);
  }

  static String loop(Ast.While loop) {
    return loop("while", loop.flavor(), "(" + statement(loop.condition()) + ")", loop.body());
  }

  static String loop(Ast.Loop loop) {
    return "loop" + flavor(loop.flavor(), Flavor.SEMICOLON) + "\n" + clause(loop.body());
  }

  static String tagged(Ast.Tagged tagged) {
    return Expressions.expression(tagged.tag()) + ": " + nonempty(tagged.body());
  }

  static String timeout(Ast.Timeout timeout) {
    return "timeout ("
        + Expressions.expression(timeout.duration())
        + ")\n"
        + clause(timeout.body());
  }

  // ------------------------------------------------------------------------------ composition

  static String sequence(Ast.Sequence sequence) {
    List<Ast> statements = sequence.statements();
    List<Flavor> separators = sequence.separators();
    var text = new StringBuilder();
    for (int i = 0; i < statements.size(); i++) {
      Flavor separator = i < separators.size() ? separators.get(i) : null;
      Flavor context = separators.isEmpty() ? Flavor.SEMICOLON : separators.get(0);
      text.append(part(statements.get(i), context));
      if (separator == Flavor.PIPE || separator == Flavor.AND) {
        text.append(' ').append(separator.text()).append(' ');
      } else if (separator != null) {
        text.append(separator.text()).append(i + 1 < statements.size() ? " " : "");
      }
    }
    return text.toString();
  }

  /** A statement in a sequence: one that binds looser goes between braces. */
  private static String part(Ast statement, Flavor context) {
    boolean tight =
        !(statement instanceof Ast.Sequence inner)
            || !inner.separators().isEmpty()
                && strength(inner.separators().get(0)) > strength(context);
    boolean missing =
        statement instanceof Ast.Noop && (context == Flavor.PIPE || context == Flavor.AND);
    return tight && !missing ? statement(statement) : clause(statement);
  }

  private static int strength(Flavor separator) {
    return switch (separator) {
      case SEMICOLON, COMMA -> 0;
      case PIPE -> 1;
      case AND -> 2;
    };
  }

  /** The statements of a body, each on its line unless there is only one. */
  static String lines(Ast.Sequence sequence) {
    List<Ast> statements = sequence.statements();
    if (statements.size() == 1) {
      boolean background =
          !sequence.separators().isEmpty() && sequence.separators().get(0) == Flavor.COMMA;
      return part(statements.get(0), Flavor.SEMICOLON) + (background ? "," : "");
    }
    boolean tight = !sequence.separators().isEmpty() && strength(sequence.separators().get(0)) > 0;
    if (tight) {
      return sequence(sequence);
    }
    var text = new StringBuilder();
    for (int i = 0; i < statements.size(); i++) {
      text.append(i == 0 ? "" : "\n").append(part(statements.get(i), Flavor.SEMICOLON));
      if (i < sequence.separators().size()) {
        text.append(sequence.separators().get(i).text());
      }
    }
    return text.toString();
  }

  static String scope(Ast.Scope scope) {
    String lines = lines(scope.body());
    if (lines.isEmpty()) {
      return "{}";
    }
    boolean single = scope.body().statements().size() == 1 && lines.indexOf('\n') < 0;
    return single ? "{ " + lines + " }" : "{\n" + Printer.indent(lines) + "\n}";
  }

  /** A scope that never fits on one line. */
  static String block(Ast.Scope scope) {
    String lines = lines(scope.body());
    return lines.isEmpty() ? "{}" : "{\n" + Printer.indent(lines) + "\n}";
  }

  /** What a control structure governs: always between braces. */
  static String clause(Ast body) {
    if (body instanceof Ast.Scope scope) {
      return scope(scope);
    }
    String text = statement(body);
    if (text.isEmpty()) {
      return "{}";
    }
    return text.indexOf('\n') < 0 ? "{ " + text + " }" : "{\n" + Printer.indent(text) + "\n}";
  }

  private static String nonempty(Ast body) {
    return body instanceof Ast.Noop || body instanceof Ast.Sequence
        ? clause(body)
        : statement(body);
  }

  static String optional(String keyword, @Nullable Ast body) {
    return body == null ? "" : "\n" + keyword + "\n" + clause(body);
  }

  static String value(@Nullable Ast value) {
    return value == null ? "" : " " + Expressions.expression(value);
  }

  // ------------------------------------------------------------------------------ structures

  static String doBlock(Ast.Do block) {
    String target =
        block.target() == null ? "" : " (" + Expressions.expression(block.target()) + ")";
    return "do" + target + "\n" + scope(block.body());
  }

  private static String flavor(Flavor flavor, Flavor usual) {
    return flavor == usual ? "" : flavor.text();
  }

  static String loop(String keyword, Flavor flavor, String head, Ast body) {
    return keyword + flavor(flavor, Flavor.SEMICOLON) + " " + head + "\n" + clause(body);
  }

  static String clauses(Ast.For loop) {
    return "("
        + clauseOf(loop.init())
        + ";"
        + spaced(loop.condition())
        + ";"
        + spaced(loop.step())
        + ")";
  }

  private static String clauseOf(@Nullable Ast tree) {
    return tree == null ? "" : statement(tree);
  }

  private static String spaced(@Nullable Ast tree) {
    return tree == null ? "" : " " + statement(tree);
  }

  static String range(Ast.ForEach loop) {
    String range = Expressions.expression(loop.range());
    return loop.name() == null
        ? "(" + range + ")"
        : "(var " + StringEscape.name(loop.name()) + " : " + range + ")";
  }

  static String every(Ast.Every every) {
    String period = "(" + Expressions.expression(every.period()) + ")";
    String flavor = flavor(every.flavor(), Flavor.COMMA);
    return "every" + flavor + " " + period + "\n" + clause(every.body());
  }

  static String choice(Ast.Switch choice) {
    var text = new StringBuilder("switch (").append(statement(choice.value())).append(")\n{\n");
    for (Ast.Case one : choice.cases()) {
      text.append("  case ").append(guarded(one.pattern(), one.guard())).append(":\n");
      text.append(alternative(one.body()));
    }
    if (choice.defaultClause() != null) {
      text.append("  default:\n").append(alternative(choice.defaultClause()));
    }
    return text.append('}').toString();
  }

  private static String alternative(Ast.Sequence body) {
    String lines = lines(body);
    return lines.isEmpty() ? "" : Printer.indent(Printer.indent(lines)) + "\n";
  }

  static String guarded(Ast pattern, @Nullable Ast guard) {
    return Expressions.expression(pattern)
        + (guard == null ? "" : " if " + Expressions.expression(guard));
  }

  static String attempt(Ast.Try attempt) {
    var text = new StringBuilder("try\n").append(scope(attempt.body()));
    for (Ast.Catch one : attempt.catches()) {
      text.append("\ncatch");
      if (one.pattern() != null) {
        text.append(" (").append(guarded(one.pattern(), one.guard())).append(")");
      }
      text.append('\n').append(scope(one.body()));
    }
    return text.append(optional("else", attempt.elseClause()))
        .append(optional("finally", attempt.finallyClause()))
        .toString();
  }

  static String claim(Ast.Assert claim) {
    if (!claim.block()) {
      return "assert(" + Expressions.expression(claim.claims().get(0)) + ")";
    }
    var text = new StringBuilder("assert\n{\n");
    for (Ast one : claim.claims()) {
      text.append(Printer.indent(statement(one))).append(";\n");
    }
    return text.append('}').toString();
  }
}
