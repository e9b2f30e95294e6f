package org.urbi.lang.parse;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.UrbiscriptParser.AtStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.BodyContext;
import org.urbi.lang.grammar.UrbiscriptParser.ConditionContext;
import org.urbi.lang.grammar.UrbiscriptParser.EmitStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.ExpressionContext;
import org.urbi.lang.grammar.UrbiscriptParser.NameContext;
import org.urbi.lang.grammar.UrbiscriptParser.WheneverStatementContext;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Span;

/** Event-based constructs (manual, "Parallel and event-based flow control"). */
final class EventBuilder {
  private final TreeBuilder builder;

  EventBuilder(TreeBuilder builder) {
    this.builder = builder;
  }

  Ast at(AtStatementContext context) {
    builder.statements.flavor(context.AT().getSymbol(), context.flavor(), null);
    boolean sync = synchronous(context);
    BodyContext onLeave = context.ONLEAVE() == null ? null : context.body(1);
    return new Ast.At(
        builder.span(context),
        sync,
        condition(context.condition()),
        builder.statements.body(context.body(0)),
        onLeave == null ? null : builder.statements.body(onLeave));
  }

  private boolean synchronous(AtStatementContext context) {
    String found = null;
    for (NameContext name : context.name()) {
      String text = TreeBuilder.text(name);
      if (!text.equals("sync") && !text.equals("async")) {
        throw builder.failure(builder.span(context), SyntaxProblem.UNEXPECTED_KEYWORD, text);
      }
      if (text.equals(found)) {
        throw builder.failure(builder.span(context), SyntaxProblem.DUPLICATE_KEYWORD, text);
      }
      if (found != null) {
        throw builder.failure(
            builder.span(context), SyntaxProblem.INCOMPATIBLE_KEYWORDS, found, text);
      }
      found = text;
    }
    return "sync".equals(found);
  }

  Ast whenever(WheneverStatementContext context) {
    return new Ast.Whenever(
        builder.span(context),
        condition(context.condition()),
        builder.statements.body(context.body(0)),
        context.ELSE() == null ? null : builder.statements.body(context.body(1)));
  }

  Ast.Condition condition(ConditionContext context) {
    Span span = builder.span(context);
    Ast expression = builder.expressions.expression(context.expression(0));
    if (context.QUESTION() == null) {
      return new Ast.WhenTrue(span, expression, duration(context));
    }
    List<Ast> patterns = null;
    if (context.arguments() != null) {
      patterns =
          builder.literals.inPattern(() -> {
            var list = new ArrayList<Ast>();
            for (ExpressionContext pattern : context.arguments().expression()) {
              list.add(builder.expressions.expression(pattern));
            }
            return List.copyOf(list);
          });
    }
    Ast guard = context.guard == null ? null : builder.expressions.value(context.guard);
    Ast event = builder.noDeclaration(expression);
    return new Ast.WhenEmitted(span, event, patterns, guard, duration(context));
  }

  private @Nullable Ast duration(ConditionContext context) {
    return context.duration == null ? null : builder.expressions.value(context.duration);
  }

  /** {@code e!(arguments) ~ duration}. */
  Ast lasting(Span span, Ast emission, Token tilde, ExpressionContext duration) {
    if (emission instanceof Ast.Emit emit) {
      Ast value = builder.expressions.value(duration);
      return new Ast.Emit(span, emit.event(), emit.arguments(), value);
    }
    throw builder.unexpected(tilde);
  }

  Ast emit(EmitStatementContext context) {
    Span span = builder.span(context);
    builder.warn(span, SyntaxProblem.DEPRECATED_EMIT);
    Ast event = builder.expressions.value(context.expression(0));
    List<Ast> arguments = null;
    if (event instanceof Ast.Message m && m.arguments() != null && !m.name().equals("[]")) {
      arguments = m.arguments();
      event =
          m.name().equals("()")
              ? requireNonNull(m.target(), "what is called")
              : new Ast.Message(m.span(), m.target(), m.name(), null, m.nameSpan());
    }
    Ast emission = new Ast.Emit(span, event, arguments, null);
    return context.TILDE() == null
        ? emission
        : lasting(span, emission, context.TILDE().getSymbol(), context.expression(1));
  }
}
