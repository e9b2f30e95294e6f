package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.List;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.UrbiLexer;
import org.urbi.lang.grammar.UrbiParser.*;
import org.urbi.lang.source.Span;

/** Trees of sequences and of statements. */
final class Statements {
  private final Errors errors;
  private final Expressions expressions;
  private final Control control;

  Statements(Errors errors) {
    this.errors = errors;
    this.expressions = new Expressions(errors, this);
    this.control = new Control(errors, this, expressions);
  }

  /** Statements separated by semicolons and commas. */
  Ast.Sequence sequence(SequenceContext context) {
    List<Ast> statements = new ArrayList<>();
    List<Ast.Flavor> separators = new ArrayList<>();
    for (int i = 0; i < context.getChildCount(); i++) {
      switch (context.getChild(i)) {
        case ParallelContext parallel -> statements.add(parallel(parallel));
        case TerminalNode word -> {
          Token separator = word.getSymbol();
          if (statements.size() == separators.size()) {
            int at = separator.getStartIndex();
            statements.add(new Ast.Noop(errors.span(at, at)));
          }
          separators.add(
              separator.getType() == UrbiLexer.SEMI ? Ast.Flavor.SEMICOLON : Ast.Flavor.COMMA);
        }
        default -> {}
      }
    }
    return new Ast.Sequence(errors.span(context), List.copyOf(statements), List.copyOf(separators));
  }

  private Ast parallel(ParallelContext context) {
    List<Ast> parts = context.piped().stream().map(this::piped).toList();
    return chain(context, parts, context.AMP(), Ast.Flavor.AND);
  }

  private Ast piped(PipedContext context) {
    List<Ast> parts = context.statement().stream().map(this::statement).toList();
    return chain(context, parts, context.PIPE(), Ast.Flavor.PIPE);
  }

  private Ast chain(
      ParserRuleContext context,
      List<Ast> parts,
      List<TerminalNode> separators,
      Ast.Flavor flavor) {
    if (separators.isEmpty()) {
      return parts.getFirst();
    }
    List<Ast> all = new ArrayList<>(parts);
    if (separators.size() == parts.size()) {
      int end = separators.getLast().getSymbol().getStopIndex() + 1;
      Span nothing = errors.span(end, end);
      all.add(new Ast.Scope(nothing, new Ast.Sequence(nothing, List.of(), List.of())));
    }
    List<Ast.Flavor> flavors = separators.stream().map(word -> flavor).toList();
    return new Ast.Sequence(errors.span(context), List.copyOf(all), flavors);
  }

  Ast statement(StatementContext context) {
    if (context instanceof ExpressionStatementContext statement) {
      Ast expression = expressions.expression(statement.expression());
      return statement.COLON() == null
          ? expression
          : tagged(errors.span(context), expression, statement.body(), statement.COLON());
    }
    expressions.deeper(1, context);
    Ast statement = control.statement(context);
    expressions.deeper(-1, context);
    return statement;
  }

  /** {@code tag: body}. */
  Ast tagged(Span span, Ast tag, BodyContext body, TerminalNode colon) {
    if (tag instanceof Ast.Declaration declaration && declaration.value() == null) {
      errors.add(errors.span(colon.getSymbol()), "unexpected :");
    }
    if (body != null) {
      expressions.deeper(1, body);
    }
    Ast statement = body(body, colon.getSymbol());
    if (body != null) {
      expressions.deeper(-1, body);
    }
    return new Ast.Tagged(span, tag, statement);
  }

  /** What a statement governs; nothing at all is nothing to do. */
  Ast body(BodyContext context, Token before) {
    if (context == null) {
      int at = before.getStopIndex() + 1;
      return new Ast.Noop(errors.span(at, at));
    }
    return statement(context.statement());
  }

  /** The flavor after a loop's keyword. */
  Ast.Flavor flavor(FlavorContext context, Ast.Flavor byDefault) {
    if (context == null) {
      return byDefault;
    }
    return switch (context.getText()) {
      case ";" -> Ast.Flavor.SEMICOLON;
      case "," -> Ast.Flavor.COMMA;
      case "&" -> Ast.Flavor.AND;
      default -> Ast.Flavor.PIPE;
    };
  }
}
