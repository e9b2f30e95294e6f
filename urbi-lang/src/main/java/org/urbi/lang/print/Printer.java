package org.urbi.lang.print;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.urbi.lang.ast.Ast;

/**
 * Code as the interpreter shows it: operators are messages, and a block of several statements has
 * one on each line.
 */
public final class Printer {
  private static final Set<String> COMPARISONS =
      Set.of("==", "!=", "===", "!==", "~=", "=~=", "<", "<=", ">", ">=");

  private final StringBuilder out = new StringBuilder();
  private int indent;

  private Printer() {}

  /** One tree. */
  public static String print(Ast ast) {
    var printer = new Printer();
    printer.tree(ast);
    return printer.out.toString();
  }

  /** The claim of an assertion: its comparison is shown as it was written. */
  public static String claim(Ast ast) {
    if (ast instanceof Ast.Message m && m.arguments() != null && m.arguments().size() == 1) {
      String argument = operand(m.arguments().getFirst());
      if (m.target() != null && COMPARISONS.contains(m.name())) {
        return operand(m.target()) + ' ' + m.name() + ' ' + argument;
      } else if (m.target() != null && isMembership(m)) {
        String word = m.name().equals("has") ? " in " : " not in ";
        return argument + word + operand(m.target());
      }
    }
    return print(ast);
  }

  private static String operand(Ast ast) {
    return isOpen(ast) ? '(' + print(ast) + ')' : print(ast);
  }

  /** Whether {@code in} was written: its argument comes first. */
  private static boolean isMembership(Ast.Message message) {
    return (message.name().equals("has") || message.name().equals("hasNot"))
        && message.arguments().getFirst().span().begin() < message.target().span().begin();
  }

  private void tree(Ast ast) {
    switch (ast) {
      case Ast.FloatLiteral a -> out.append(FloatFormat.format(a.value()));
      case Ast.StringLiteral a ->
          out.append('"').append(StringEscape.escape(a.value())).append('"');
      case Ast.ListLiteral a -> list("[", a.elements(), "]");
      case Ast.TupleLiteral a -> list("(", a.elements(), a.elements().size() == 1 ? ",)" : ")");
      case Ast.DictionaryLiteral a -> dictionary(a);
      case Ast.This a -> out.append("this");
      case Ast.CallMessage a -> out.append("call");
      case Ast.Message a -> message(a);
      case Ast.And a -> logic(a.left(), " && ", a.right());
      case Ast.Or a -> logic(a.left(), " || ", a.right());
      case Ast.SlotAccess a -> {
        if (a.target() != null) {
          tree(a.target());
          out.append('.');
        }
        out.append('&').append(Names.name(a.name()));
      }
      case Ast.Property a -> {
        slot(a.target(), a.slot());
        out.append("->").append(Names.name(a.name()));
      }
      case Ast.Declaration a -> declaration(a);
      case Ast.Assignment a -> pair(a.target(), " = ", a.value());
      case Ast.OperatorAssignment a -> pair(a.target(), ' ' + a.operator() + ' ', a.value());
      case Ast.Postfix a -> {
        tree(a.target());
        out.append(a.operator());
      }
      case Ast.Trajectory a -> trajectory(a);
      case Ast.Function a -> {
        out.append(a.closure() ? "closure " : "function ");
        function(a);
      }
      case Ast.FunctionDefinition a -> {
        out.append(a.function().closure() ? "closure " : "function ");
        tree(a.name());
        out.append(a.function().formals() == null ? " " : "");
        function(a.function());
      }
      case Ast.Accessor a -> {
        out.append(a.setter() ? "set " : "get ");
        tree(a.name());
        out.append(a.function().formals() == null ? " " : "");
        function(a.function());
      }
      case Ast.Sequence a -> sequence(a);
      case Ast.Scope a -> braces(a);
      case Ast.Noop a -> {}
      case Ast.Emit a -> {
        tree(a.event());
        out.append('!');
        if (a.arguments() != null) {
          list("(", a.arguments(), ")");
        }
        duration(a.duration());
      }
      default -> statement(ast);
    }
  }

  private void statement(Ast ast) {
    switch (ast) {
      case Ast.ClassDefinition a -> classDefinition(a);
      case Ast.PackageDefinition a -> {
        out.append("package ");
        tree(a.name());
        newline();
        block(a.body());
      }
      case Ast.Import a ->
          out.append("import ")
              .append(a.path().stream().map(Names::name).collect(Collectors.joining(".")))
              .append(a.all() ? ".*" : "");
      case Ast.EnumDefinition a -> {
        out.append("enum ");
        tree(a.name());
        String values = a.values().stream().map(Names::name).collect(Collectors.joining(", "));
        out.append(" { ").append(values).append(" }");
      }
      case Ast.Do a -> {
        out.append("do");
        if (a.target() != null) {
          list(" (", List.of(a.target()), ")");
        }
        body(a.body());
      }
      case Ast.If a -> {
        headed("if", a.condition(), a.thenClause());
        clause("else", a.elseClause());
      }
      case Ast.While a -> headed("while" + flavor(a.flavor()), a.condition(), a.body());
      case Ast.For a -> {
        out.append("for").append(flavor(a.flavor())).append(" (");
        optional("", a.init());
        out.append(';');
        optional(" ", a.condition());
        out.append(';');
        optional(" ", a.step());
        out.append(')');
        body(a.body());
      }
      case Ast.ForEach a -> {
        out.append("for").append(flavor(a.flavor())).append(" (");
        if (a.name() != null) {
          out.append("var ").append(Names.name(a.name())).append(" : ");
        }
        tree(a.range());
        out.append(')');
        body(a.body());
      }
      case Ast.Loop a -> {
        out.append("loop").append(flavor(a.flavor()));
        body(a.body());
      }
      case Ast.Switch a -> switching(a);
      case Ast.Return a -> word("return", a.value());
      case Ast.Throw a -> word("throw", a.value());
      case Ast.Break a -> out.append("break");
      case Ast.Continue a -> out.append("continue");
      case Ast.Try a -> trying(a);
      case Ast.Assert a -> assertion(a);
      case Ast.Tagged a -> pair(a.tag(), ": ", a.body());
      case Ast.Watch a -> list("watch(", List.of(a.expression()), ")");
      case Ast.WaitUntil a -> conditioned("waituntil", a.condition());
      case Ast.At a -> {
        conditioned(a.sync() ? "at sync" : "at", a.condition());
        body(a.body());
        clause("onleave", a.onLeave());
      }
      case Ast.Whenever a -> {
        conditioned("whenever", a.condition());
        body(a.body());
        clause("else", a.elseClause());
      }
      case Ast.Every a -> {
        String flavor = a.flavor() == Ast.Flavor.COMMA ? "" : a.flavor().text();
        headed("every" + flavor, a.period(), a.body());
      }
      case Ast.Timeout a -> headed("timeout", a.duration(), a.body());
      case Ast.StopIf a -> {
        conditioned("stopif", a.condition());
        body(a.body());
      }
      case Ast.FreezeIf a -> {
        conditioned("freezeif", a.condition());
        body(a.body());
      }
      default -> throw new IllegalArgumentException(ast.getClass().getSimpleName());
    }
  }

  private void message(Ast.Message a) {
    // The implicit call of what is no name: {@code f(1)(2)}.
    if (a.target() != null && a.name().equals("()")) {
      tree(a.target());
    } else {
      slot(a.target(), a.name());
    }
    if (a.arguments() != null) {
      list("(", a.arguments(), ")");
    }
  }

  private void slot(Ast target, String name) {
    if (target != null) {
      closed(target, isOpen(target));
      out.append('.');
    }
    out.append(Names.name(name));
  }

  /** Whether a tree needs parentheses to be the target of a message. */
  private static boolean isOpen(Ast ast) {
    return switch (ast) {
      case Ast.And a -> true;
      case Ast.Or a -> true;
      case Ast.Assignment a -> true;
      case Ast.OperatorAssignment a -> true;
      case Ast.Declaration a -> true;
      case Ast.Trajectory a -> true;
      case Ast.Tagged a -> true;
      default -> false;
    };
  }

  private void closed(Ast ast, boolean parentheses) {
    out.append(parentheses ? "(" : "");
    tree(ast);
    out.append(parentheses ? ")" : "");
  }

  /** Operands of {@code &&} and {@code ||}; these may stand in each other, to the left. */
  private void logic(Ast left, String word, Ast right) {
    boolean or = word.contains("|");
    boolean chain = left instanceof Ast.And || or && left instanceof Ast.Or;
    closed(left, !chain && isOpen(left));
    out.append(word);
    closed(right, isOpen(right) && !(or && right instanceof Ast.And));
  }

  private void pair(Ast left, String word, Ast right) {
    tree(left);
    out.append(word);
    tree(right);
  }

  private void list(String open, List<Ast> elements, String close) {
    out.append(open);
    String separator = "";
    for (Ast element : elements) {
      out.append(separator);
      tree(element);
      separator = ", ";
    }
    out.append(close);
  }

  private void dictionary(Ast.DictionaryLiteral a) {
    if (a.entries().isEmpty()) {
      out.append("[ => ]");
      return;
    }
    out.append('[');
    indent++;
    for (Ast.Entry entry : a.entries()) {
      newline();
      pair(entry.key(), " => ", entry.value());
      out.append(',');
    }
    indent--;
    newline();
    out.append(']');
  }

  private void declaration(Ast.Declaration a) {
    out.append(a.constant() ? "const var " : "var ");
    slot(a.target(), a.name());
    optional(": ", a.type());
    optional(" = ", a.value());
  }

  private void trajectory(Ast.Trajectory a) {
    tree(a.target());
    out.append(" =");
    optional(" ", a.value());
    for (Ast.Modifier modifier : a.modifiers()) {
      out.append(' ').append(modifier.name()).append(": ");
      tree(modifier.value());
    }
  }

  private void function(Ast.Function a) {
    if (a.formals() != null) {
      out.append('(');
      String separator = "";
      for (Ast.Formal formal : a.formals()) {
        out.append(separator).append("var ").append(Names.name(formal.name()));
        out.append(formal.variadic() ? "[]" : "");
        optional(": ", formal.type());
        optional(" = ", formal.defaultValue());
        separator = ", ";
      }
      out.append(") ");
    }
    braces(a.body());
  }

  private void classDefinition(Ast.ClassDefinition a) {
    out.append("class ");
    tree(a.name());
    if (!a.protos().isEmpty()) {
      list(": ", a.protos(), "");
    }
    if (a.body() != null) {
      newline();
      block(a.body());
    }
  }

  // ------------------------------------------------------------------ statements and braces

  /** A top-level sequence has a statement on each line; others are on one line. */
  private void sequence(Ast.Sequence a) {
    for (int i = 0; i < a.statements().size(); i++) {
      tree(a.statements().get(i));
      if (i < a.separators().size()) {
        Ast.Flavor separator = a.separators().get(i);
        boolean tight = separator == Ast.Flavor.SEMICOLON || separator == Ast.Flavor.COMMA;
        out.append(tight ? separator.text() : ' ' + separator.text());
        if (i + 1 < a.statements().size()) {
          if (tight) {
            newline();
          } else {
            out.append(' ');
          }
        }
      }
    }
  }

  /** Braces on one line around one statement, around several on as many. */
  private void braces(Ast.Scope scope) {
    Ast.Sequence body = scope.body();
    if (body.statements().isEmpty()) {
      out.append("{}");
    } else if (body.statements().size() == 1 && body.separators().size() <= 1) {
      out.append("{ ");
      tree(body.statements().getFirst());
      out.append(" }");
    } else {
      block(scope);
    }
  }

  private void block(Ast.Scope scope) {
    out.append('{');
    if (!scope.body().statements().isEmpty()) {
      indent++;
      newline();
      sequence(scope.body());
      indent--;
      newline();
    }
    out.append('}');
  }

  /** What a statement governs, in braces, on its own line. */
  private void body(Ast body) {
    newline();
    if (body instanceof Ast.Scope scope) {
      braces(scope);
    } else if (body instanceof Ast.Noop) {
      out.append("{}");
    } else {
      out.append("{ ");
      tree(body);
      out.append(" }");
    }
  }

  private void clause(String word, Ast body) {
    if (body != null) {
      newline();
      out.append(word);
      body(body);
    }
  }

  private void headed(String word, Ast head, Ast body) {
    list(word + " (", List.of(head), ")");
    body(body);
  }

  private void word(String word, Ast value) {
    out.append(word);
    optional(" ", value);
  }

  private void optional(String before, Ast ast) {
    if (ast != null) {
      out.append(before);
      tree(ast);
    }
  }

  private static String flavor(Ast.Flavor flavor) {
    return flavor == Ast.Flavor.SEMICOLON ? "" : flavor.text();
  }

  private void conditioned(String word, Ast.Condition condition) {
    out.append(word).append(" (");
    switch (condition) {
      case Ast.WhenTrue c -> tree(c.expression());
      case Ast.WhenEmitted c -> {
        tree(c.event());
        out.append('?');
        if (c.patterns() != null) {
          list("(", c.patterns(), ")");
        }
        optional(" if ", c.guard());
      }
    }
    duration(condition.duration());
    out.append(')');
  }

  private void duration(Ast duration) {
    optional(" ~ ", duration);
  }

  private void switching(Ast.Switch a) {
    list("switch (", List.of(a.value()), ")");
    newline();
    out.append('{');
    indent++;
    for (Ast.Case c : a.cases()) {
      newline();
      out.append("case ");
      tree(c.pattern());
      optional(" if ", c.guard());
      caseBody(c.body());
    }
    if (a.defaultClause() != null) {
      newline();
      out.append("default");
      caseBody(a.defaultClause());
    }
    indent--;
    newline();
    out.append('}');
  }

  private void caseBody(Ast.Sequence body) {
    out.append(':');
    if (!body.statements().isEmpty()) {
      indent++;
      newline();
      sequence(body);
      indent--;
    }
  }

  private void trying(Ast.Try a) {
    out.append("try");
    body(a.body());
    for (Ast.Catch c : a.catches()) {
      newline();
      out.append("catch");
      if (c.pattern() != null) {
        out.append(" (");
        tree(c.pattern());
        optional(" if ", c.guard());
        out.append(')');
      }
      body(c.body());
    }
    clause("else", a.elseClause());
    clause("finally", a.finallyClause());
  }

  private void assertion(Ast.Assert a) {
    if (!a.block()) {
      String claims = a.claims().stream().map(Printer::claim).collect(Collectors.joining(", "));
      out.append("assert(").append(claims).append(')');
      return;
    }
    out.append("assert");
    newline();
    out.append('{');
    indent++;
    for (Ast claim : a.claims()) {
      newline();
      out.append(claim(claim)).append(';');
    }
    indent--;
    newline();
    out.append('}');
  }

  private void newline() {
    out.append('\n').append("  ".repeat(indent));
  }
}
