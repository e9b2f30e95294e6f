package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.List;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.Ast.Flavor;
import org.urbi.lang.grammar.UrbiParser.*;
import org.urbi.lang.source.Span;

/** Trees of the statements that begin with a keyword. */
final class Control {
  private final Errors errors;
  private final Statements statements;
  private final Expressions expressions;
  private final Primaries primaries;

  Control(Errors errors, Statements statements, Expressions expressions) {
    this.errors = errors;
    this.statements = statements;
    this.expressions = expressions;
    this.primaries = expressions.primaries();
  }

  Ast statement(StatementContext context) {
    Span span = errors.span(context);
    return switch (context) {
      case IfStatementContext c ->
          new Ast.If(
              span,
              question(c.sequence(), c.RPAREN()),
              first(c.body(), c.RPAREN(), c.ELSE()),
              second(c.body(), c.ELSE(), c));
      case WhileStatementContext c ->
          new Ast.While(
              span,
              flavor(c.flavor(), "while", c.WHILE(), Flavor.SEMICOLON, "|;,"),
              question(c.sequence(), c.RPAREN()),
              body(c.body(), c.RPAREN()));
      case ForEachContext c -> forEach(c, span);
      case ForStatementContext c ->
          new Ast.For(
              span,
              flavor(c.flavor(), "for", c.FOR(), Flavor.SEMICOLON, "|;"),
              optional(c.init),
              optional(c.condition_),
              optional(c.step),
              body(c.body(), c.RPAREN()));
      case LoopStatementContext c ->
          new Ast.Loop(
              span,
              flavor(c.flavor(), "loop", c.LOOP(), Flavor.SEMICOLON, "|;,"),
              statements.body(c.body(), c.flavor() == null ? c.getStart() : c.flavor().stop));
      case EveryStatementContext c ->
          new Ast.Every(
              span,
              flavor(c.flavor(), "every", c.EVERY(), Flavor.COMMA, "|;,"),
              expressions.value(c.expression()),
              body(c.body(), c.RPAREN()));
      case AtStatementContext c -> at(c, span);
      case WheneverStatementContext c -> {
        flavor(c.flavor(), "whenever", c.WHENEVER(), Flavor.SEMICOLON, ";");
        yield new Ast.Whenever(
            span,
            condition(c.condition()),
            first(c.body(), c.RPAREN(), c.ELSE()),
            second(c.body(), c.ELSE(), c));
      }
      case WaitUntilStatementContext c -> new Ast.WaitUntil(span, condition(c.condition()));
      case TimeoutStatementContext c ->
          new Ast.Timeout(span, expressions.value(c.expression()), body(c.body(), c.RPAREN()));
      case StopIfStatementContext c ->
          new Ast.StopIf(span, condition(c.condition()), body(c.body(), c.RPAREN()));
      case FreezeIfStatementContext c ->
          new Ast.FreezeIf(span, condition(c.condition()), body(c.body(), c.RPAREN()));
      case SwitchStatementContext c -> switching(c, span);
      case ReturnStatementContext c -> new Ast.Return(span, optional(c.expression()));
      case ThrowStatementContext c -> new Ast.Throw(span, optional(c.expression()));
      case BreakStatementContext c -> new Ast.Break(span);
      case ContinueStatementContext c -> new Ast.Continue(span);
      case TryStatementContext c -> trying(c, span);
      case AssertStatementContext c ->
          new Ast.Assert(span, false, c.argument().stream().map(expressions::argument).toList());
      case AssertBlockContext c ->
          new Ast.Assert(
              span,
              true,
              primaries.scope(c.scope()).body().statements().stream()
                  .filter(claim -> !(claim instanceof Ast.Noop))
                  .toList());
      default -> definition(context, span);
    };
  }

  private Ast definition(StatementContext context, Span span) {
    return switch (context) {
      case ClassStatementContext c ->
          new Ast.ClassDefinition(
              span,
              primaries.place(c.path()),
              c.proto().stream().map(p -> expressions.value(p.expression())).toList(),
              c.scope() == null ? null : primaries.scope(c.scope()));
      case PackageStatementContext c ->
          new Ast.PackageDefinition(span, primaries.place(c.path()), primaries.scope(c.scope()));
      case ImportStatementContext c -> imported(c, span);
      case EnumStatementContext c ->
          new Ast.EnumDefinition(span, primaries.place(c.path()), names(c.identifier()));
      case GetStatementContext c ->
          new Ast.Accessor(
              span,
              false,
              primaries.place(c.path()),
              primaries.function(span, false, c.formals(), c.scope()));
      case SetStatementContext c ->
          new Ast.Accessor(
              span,
              true,
              primaries.place(c.path()),
              primaries.function(span, false, c.formals(), c.scope()));
      default -> throw new IllegalStateException(context.getText());
    };
  }

  private static Ast imported(ImportStatementContext context, Span span) {
    List<String> path = new ArrayList<>(names(context.identifier()));
    if (context.THIS() != null) {
      path.addFirst("this");
    }
    return new Ast.Import(span, List.copyOf(path), context.STAR() != null);
  }

  /** A condition: an expression, or statements of which the last tells. */
  private Ast question(SequenceContext context, TerminalNode end) {
    Ast.Sequence sequence = statements.sequence(context);
    if (sequence.statements().isEmpty()) {
      errors.add(errors.span(end.getSymbol()), "unexpected )");
    }
    return sequence.statements().size() == 1 && sequence.separators().isEmpty()
        ? sequence.statements().getFirst()
        : sequence;
  }

  private static List<String> names(List<IdentifierContext> identifiers) {
    return identifiers.stream().map(name -> Literals.name(name.getStart())).toList();
  }

  private Ast optional(ExpressionContext context) {
    return context == null ? null : expressions.expression(context);
  }

  private Ast body(BodyContext context, TerminalNode before) {
    return statements.body(context, before.getSymbol());
  }

  /** The clause before the word ({@code else}, {@code onleave}). */
  private Ast first(List<BodyContext> bodies, TerminalNode before, TerminalNode word) {
    boolean absent =
        bodies.isEmpty()
            || word != null
                && bodies.getFirst().getStart().getTokenIndex() > word.getSymbol().getTokenIndex();
    return body(absent ? null : bodies.getFirst(), before);
  }

  /** The clause after the word; null without the word. */
  private Ast second(List<BodyContext> bodies, TerminalNode word, StatementContext context) {
    if (word == null) {
      return null;
    }
    boolean present =
        !bodies.isEmpty()
            && bodies.getLast().getStart().getTokenIndex() > word.getSymbol().getTokenIndex();
    return body(present ? bodies.getLast() : null, word);
  }

  private Flavor flavor(
      FlavorContext context, String word, TerminalNode keyword, Flavor byDefault, String valid) {
    if (context != null && valid.indexOf(context.getText().charAt(0)) < 0) {
      errors.add(
          errors.span(keyword.getSymbol(), context.getStart()),
          "invalid flavor: " + word + context.getText());
    }
    return statements.flavor(context, byDefault);
  }

  private Ast forEach(ForEachContext context, Span span) {
    Flavor flavor = flavor(context.flavor(), "for", context.FOR(), Flavor.SEMICOLON, "|;&");
    return new Ast.ForEach(
        span,
        flavor,
        context.identifier() == null ? null : Literals.name(context.identifier().getStart()),
        expressions.value(context.expression()),
        body(context.body(), context.RPAREN()));
  }

  private Ast at(AtStatementContext context, Span span) {
    flavor(context.flavor(), "at", context.AT(), Flavor.SEMICOLON, ";");
    boolean sync = false;
    boolean async = false;
    for (IdentifierContext word : context.identifier()) {
      String text = word.getText();
      if (!text.equals("sync") && !text.equals("async")) {
        errors.add(span, "unexpected `" + text + "'");
        break;
      } else if (text.equals("sync") ? sync : async) {
        errors.add(span, "duplicate keyword: `" + text + "'");
        break;
      } else if (sync || async) {
        errors.add(span, "incompatible keywords: `sync' and `async'");
        break;
      }
      sync |= text.equals("sync");
      async |= text.equals("async");
    }
    return new Ast.At(
        span,
        sync,
        condition(context.condition()),
        first(context.body(), context.RPAREN(), context.ONLEAVE()),
        second(context.body(), context.ONLEAVE(), context));
  }

  /** What the reactive statements wait for. */
  private Ast.Condition condition(ConditionContext context) {
    ExpressionContext head = context.expression(0);
    Ast guard = context.IF() == null ? null : expressions.value(context.expression(1));
    Ast duration =
        context.TILDE() == null
            ? null
            : expressions.value(context.expression(context.expression().size() - 1));
    if (head instanceof EventExpressionContext event) {
      return new Ast.WhenEmitted(
          errors.span(context),
          expressions.value(event.expression()),
          event.arguments() == null ? null : expressions.patterns(event.arguments()),
          guard,
          duration);
    }
    if (guard != null) {
      errors.add(errors.span(context.IF().getSymbol()), "unexpected if");
    }
    return new Ast.WhenTrue(errors.span(context), expressions.value(head), duration);
  }

  private Ast switching(SwitchStatementContext context, Span span) {
    List<Ast.Case> cases = new ArrayList<>();
    for (SwitchCaseContext c : context.switchCase()) {
      cases.add(
          new Ast.Case(
              errors.span(c),
              expressions.pattern(c.expression(0)),
              c.IF() == null ? null : expressions.value(c.expression(1)),
              statements.sequence(c.sequence())));
    }
    DefaultCaseContext otherwise = context.defaultCase();
    return new Ast.Switch(
        span,
        expressions.value(context.expression()),
        List.copyOf(cases),
        otherwise == null ? null : statements.sequence(otherwise.sequence()));
  }

  private Ast trying(TryStatementContext context, Span span) {
    List<Ast.Catch> catches = new ArrayList<>();
    boolean all = false;
    for (CatchClauseContext c : context.catchClause()) {
      if (all) {
        errors.add(errors.span(c), "catch: exception already caught by a previous clause");
      }
      Ast pattern = c.expression().isEmpty() ? null : expressions.pattern(c.expression(0));
      Ast guard = c.IF() == null ? null : expressions.value(c.expression(1));
      all |= guard == null && (pattern == null || pattern instanceof Ast.Declaration);
      catches.add(new Ast.Catch(errors.span(c), pattern, guard, primaries.scope(c.scope())));
    }
    int next = context.ELSE() == null ? 1 : 2;
    return new Ast.Try(
        span,
        primaries.scope(context.scope(0)),
        List.copyOf(catches),
        context.ELSE() == null ? null : primaries.scope(context.scope(1)),
        context.FINALLY() == null ? null : primaries.scope(context.scope(next)));
  }
}
