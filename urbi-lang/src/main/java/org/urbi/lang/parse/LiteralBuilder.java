package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.BinaryLiteral;
import org.urbi.lang.grammar.UrbiToken;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.grammar.UrbiscriptParser.ElementContext;
import org.urbi.lang.grammar.UrbiscriptParser.ExpressionContext;
import org.urbi.lang.grammar.UrbiscriptParser.ListContext;
import org.urbi.lang.grammar.UrbiscriptParser.ParenthesesContext;
import org.urbi.lang.grammar.UrbiscriptParser.PrimaryContext;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Span;

/** Literals, names, and what is between brackets of any kind (manual, "Literals"). */
final class LiteralBuilder {
  private final TreeBuilder builder;

  /** Whether lists and tuples are patterns, the elements of which may be declarations. */
  private boolean pattern;

  LiteralBuilder(TreeBuilder builder) {
    this.builder = builder;
  }

  <T> T inPattern(Supplier<T> build) {
    return with(true, build);
  }

  <T> T outsidePattern(Supplier<T> build) {
    return with(false, build);
  }

  private <T> T with(boolean inside, Supplier<T> build) {
    boolean outer = pattern;
    pattern = inside;
    try {
      return build.get();
    } finally {
      pattern = outer;
    }
  }

  Ast primary(PrimaryContext context) {
    if (context.getChild(0) instanceof ParserRuleContext rule) {
      return switch (rule.getRuleIndex()) {
        case UrbiscriptParser.RULE_identifier -> identifier(context);
        case UrbiscriptParser.RULE_scope ->
            outsidePattern(() -> builder.statements.scope(context.scope()));
        case UrbiscriptParser.RULE_function ->
            outsidePattern(() -> builder.functions.function(context.function()));
        case UrbiscriptParser.RULE_parentheses -> parentheses(context.parentheses());
        default -> list(context.list());
      };
    }
    Span span = builder.span(context);
    var first = (UrbiToken) context.getStart();
    return switch (first.getType()) {
      case UrbiscriptParser.NUMBER -> new Ast.FloatLiteral(span, first.number());
      case UrbiscriptParser.DURATION -> new Ast.FloatLiteral(span, duration(context.DURATION()));
      case UrbiscriptParser.STRING -> new Ast.StringLiteral(span, glue(context.STRING()));
      case UrbiscriptParser.BINARY -> binary(span, first.binary());
      case UrbiscriptParser.THIS -> new Ast.This(span);
      case UrbiscriptParser.CALL -> callMessage(span);
      case UrbiscriptParser.NEW -> newObject(span, context);
      case UrbiscriptParser.AND -> new Ast.SlotAccess(span, null, TreeBuilder.text(context.name()));
      case UrbiscriptParser.WATCH -> new Ast.Watch(span, plain(context.expression()));
      default ->
          new Ast.Do(
              span,
              context.expression() == null ? null : plain(context.expression()),
              outsidePattern(() -> builder.statements.slots(context.scope())));
    };
  }

  private Ast plain(ExpressionContext context) {
    return outsidePattern(() -> builder.expressions.value(context));
  }

  private Ast identifier(PrimaryContext context) {
    Span span = builder.span(context);
    Token token = context.getStart();
    if (token.getType() == UrbiscriptParser.WORD && token.getText().equals("self")) {
      builder.warn(span, SyntaxProblem.DEPRECATED_SELF);
      return new Ast.This(span);
    }
    return new Ast.Message(span, null, TreeBuilder.text(context.identifier()), null, span);
  }

  private static double duration(List<TerminalNode> parts) {
    double sum = 0;
    for (TerminalNode part : parts) {
      sum += ((UrbiToken) part.getSymbol()).number();
    }
    return sum;
  }

  private static String glue(List<TerminalNode> parts) {
    if (parts.size() == 1) {
      return ((UrbiToken) parts.get(0).getSymbol()).string();
    }
    var glued = new StringBuilder();
    for (TerminalNode part : parts) {
      glued.append(((UrbiToken) part.getSymbol()).string());
    }
    return glued.toString();
  }

  /** {@code BIN 3 jpeg;abc} is {@code Binary.new("jpeg", "abc")}. */
  private static Ast binary(Span span, BinaryLiteral literal) {
    return new Ast.Message(
        span,
        new Ast.Message(span, null, "Binary", null, span),
        "new",
        List.of(
            new Ast.StringLiteral(span, literal.keywords()),
            new Ast.StringLiteral(span, literal.data())),
        span);
  }

  private Ast callMessage(Span span) {
    if (builder.enclosingFunctions == 0) {
      throw builder.failure(span, SyntaxProblem.CALL_OUTSIDE_FUNCTION);
    }
    return new Ast.CallMessage(span);
  }

  /** The name {@code new}, or the deprecated {@code new Object(arguments)}. */
  private Ast newObject(Span span, PrimaryContext context) {
    if (context.path() == null) {
      return new Ast.Message(span, null, "new", null, span);
    }
    builder.warn(span, SyntaxProblem.DEPRECATED_NEW);
    return new Ast.Message(
        span,
        builder.functions.pathExpression(context.path()),
        "new",
        context.arguments() == null ? null : builder.operands.arguments(context.arguments()),
        builder.span(context.getStart()));
  }

  private Ast parentheses(ParenthesesContext context) {
    List<ExpressionContext> inner = context.expression();
    if (inner.size() == 1 && context.COMMA().isEmpty()) {
      return element(inner.get(0));
    }
    var elements = new ArrayList<Ast>(inner.size());
    for (ExpressionContext expression : inner) {
      elements.add(element(expression));
    }
    return new Ast.TupleLiteral(builder.span(context), List.copyOf(elements));
  }

  private Ast list(ListContext context) {
    List<ElementContext> inner = context.element();
    Span span = builder.span(context);
    boolean dictionary =
        context.FAT_ARROW() != null || !inner.isEmpty() && inner.get(0).FAT_ARROW() != null;
    if (dictionary) {
      var entries = new ArrayList<Ast.Entry>(inner.size());
      for (ElementContext element : inner) {
        if (element.FAT_ARROW() == null) {
          throw builder.unexpected(next(context, element));
        }
        Ast key = element(element.expression(0));
        entries.add(new Ast.Entry(key, element(element.expression(1))));
      }
      return new Ast.DictionaryLiteral(span, List.copyOf(entries));
    }
    var elements = new ArrayList<Ast>(inner.size());
    for (ElementContext element : inner) {
      if (element.FAT_ARROW() != null) {
        throw builder.unexpected(element.FAT_ARROW().getSymbol());
      }
      elements.add(element(element.expression(0)));
    }
    return new Ast.ListLiteral(span, List.copyOf(elements));
  }

  private static Token next(ListContext list, ElementContext element) {
    int index = list.children.indexOf(element);
    return ((TerminalNode) list.getChild(index + 1)).getSymbol();
  }

  private Ast element(ExpressionContext context) {
    Ast element = builder.expressions.expression(context);
    return pattern ? element : builder.noDeclaration(element);
  }
}
