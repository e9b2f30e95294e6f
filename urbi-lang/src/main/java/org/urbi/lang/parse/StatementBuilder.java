package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.Ast.Flavor;
import org.urbi.lang.ast.LocalNames;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.grammar.UrbiscriptParser.AccessorContext;
import org.urbi.lang.grammar.UrbiscriptParser.AssertStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.AtStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.BodyContext;
import org.urbi.lang.grammar.UrbiscriptParser.CatchClauseContext;
import org.urbi.lang.grammar.UrbiscriptParser.ClassDefinitionContext;
import org.urbi.lang.grammar.UrbiscriptParser.EmitStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.EnumDefinitionContext;
import org.urbi.lang.grammar.UrbiscriptParser.EveryStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.ExpressionContext;
import org.urbi.lang.grammar.UrbiscriptParser.ExpressionStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.ExternalDeclarationContext;
import org.urbi.lang.grammar.UrbiscriptParser.FlavorContext;
import org.urbi.lang.grammar.UrbiscriptParser.ForClauseContext;
import org.urbi.lang.grammar.UrbiscriptParser.ForHeadContext;
import org.urbi.lang.grammar.UrbiscriptParser.ForStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.FreezeIfStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.IfStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.ImportStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.LoopStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.PackageDefinitionContext;
import org.urbi.lang.grammar.UrbiscriptParser.ParallelContext;
import org.urbi.lang.grammar.UrbiscriptParser.PipeContext;
import org.urbi.lang.grammar.UrbiscriptParser.ReturnStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.ScopeContext;
import org.urbi.lang.grammar.UrbiscriptParser.SequenceContext;
import org.urbi.lang.grammar.UrbiscriptParser.StatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.StopIfStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.SwitchCaseContext;
import org.urbi.lang.grammar.UrbiscriptParser.SwitchStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.ThrowStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.TimeoutStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.TryStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.WaitUntilStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.WheneverStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.WhileStatementContext;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Span;

/** Composition and flow control (manual, "Statement Separators", "Imperative flow control"). */
final class StatementBuilder {
  /** A statement in a statement takes as much stack as that many expressions. */
  private static final int STATEMENT_LEVELS = 3;

  private static final Set<Flavor> SEQUENTIAL_OR_BACKGROUND =
      EnumSet.of(Flavor.SEMICOLON, Flavor.PIPE, Flavor.COMMA);
  private static final Set<Flavor> ALL_AT_ONCE_TOO =
      EnumSet.of(Flavor.SEMICOLON, Flavor.PIPE, Flavor.AND);

  private final TreeBuilder builder;

  StatementBuilder(TreeBuilder builder) {
    this.builder = builder;
  }

  // ------------------------------------------------------------------------------ composition

  Ast.Sequence sequence(SequenceContext context) {
    var statements = new ArrayList<Ast>();
    var separators = new ArrayList<Flavor>();
    if (context.children != null) {
      for (ParseTree child : context.children) {
        if (child instanceof PipeContext pipe) {
          statements.add(pipe(pipe));
        } else {
          Token token = ((TerminalNode) child).getSymbol();
          if (statements.size() == separators.size()) {
            int at = token.getStartIndex();
            statements.add(new Ast.Noop(builder.span(at, at)));
          }
          separators.add(
              token.getType() == UrbiscriptParser.SEMICOLON ? Flavor.SEMICOLON : Flavor.COMMA);
        }
      }
    }
    return new Ast.Sequence(
        builder.span(context), List.copyOf(statements), List.copyOf(separators));
  }

  Ast pipe(PipeContext context) {
    return context.getChildCount() == 1
        ? parallel(context.parallel(0))
        : composition(context, Flavor.PIPE);
  }

  private Ast parallel(ParallelContext context) {
    return context.getChildCount() == 1
        ? statement(context.statement(0))
        : composition(context, Flavor.AND);
  }

  /** Statements between {@code |} or {@code &}: a missing one is an empty scope. */
  private Ast composition(ParserRuleContext context, Flavor flavor) {
    var statements = new ArrayList<Ast>();
    var separators = new ArrayList<Flavor>();
    for (ParseTree child : context.children) {
      if (child instanceof TerminalNode separator) {
        if (statements.size() == separators.size()) {
          statements.add(missing(separator.getSymbol().getStartIndex()));
        }
        separators.add(flavor);
      } else {
        statements.add(
            child instanceof ParallelContext parallel
                ? parallel(parallel)
                : statement((StatementContext) child));
      }
    }
    if (statements.size() == separators.size()) {
      statements.add(missing(TreeBuilder.end(context)));
    }
    return new Ast.Sequence(
        builder.span(context), List.copyOf(statements), List.copyOf(separators));
  }

  private Ast missing(int at) {
    Span span = builder.span(at, at);
    return new Ast.Scope(span, new Ast.Sequence(span, List.of(), List.of()));
  }

  /** A scope whose declarations make slots of an object: the body of a class. */
  Ast.Scope slots(ScopeContext context) {
    return new Ast.Scope(builder.span(context), sequence(context.sequence()));
  }

  /** A scope whose declarations make local variables, each once. */
  Ast.Scope scope(ScopeContext context) {
    Ast.Scope scope = slots(context);
    var names = new HashSet<String>();
    for (LocalNames.Named named : LocalNames.in(scope.body())) {
      if (!names.add(named.name())) {
        throw builder.failure(
            named.declaration().span(), SyntaxProblem.VARIABLE_REDEFINITION, named.name());
      }
    }
    return scope;
  }

  /** The body of a control structure; an empty statement is allowed, but gets a warning. */
  Ast body(BodyContext context) {
    if (context.statement() != null) {
      return statement(context.statement());
    }
    int at = TreeBuilder.begin(context);
    builder.warn(builder.span(at, at + 1), SyntaxProblem.EMPTY_STATEMENT);
    return new Ast.Noop(builder.span(at, at));
  }

  // ------------------------------------------------------------------------------ statements

  private Ast statement(StatementContext context) {
    builder.enter(STATEMENT_LEVELS, context);
    Ast tree = anyStatement(context);
    builder.leave(STATEMENT_LEVELS);
    return tree;
  }

  private Ast anyStatement(StatementContext context) {
    ParseTree child = context.getChild(0);
    Span span = builder.span(context);
    return switch (((ParserRuleContext) child).getRuleIndex()) {
      case UrbiscriptParser.RULE_expressionStatement ->
          expression((ExpressionStatementContext) child);
      case UrbiscriptParser.RULE_ifStatement -> conditional((IfStatementContext) child);
      case UrbiscriptParser.RULE_whileStatement -> whileLoop((WhileStatementContext) child);
      case UrbiscriptParser.RULE_forStatement -> forLoop((ForStatementContext) child);
      case UrbiscriptParser.RULE_loopStatement -> loop((LoopStatementContext) child);
      case UrbiscriptParser.RULE_switchStatement -> choice((SwitchStatementContext) child);
      case UrbiscriptParser.RULE_everyStatement -> every((EveryStatementContext) child);
      case UrbiscriptParser.RULE_atStatement -> builder.events.at((AtStatementContext) child);
      case UrbiscriptParser.RULE_wheneverStatement ->
          builder.events.whenever((WheneverStatementContext) child);
      case UrbiscriptParser.RULE_waitUntilStatement ->
          new Ast.WaitUntil(
              span, builder.events.condition(((WaitUntilStatementContext) child).condition()));
      case UrbiscriptParser.RULE_timeoutStatement -> {
        var timeout = (TimeoutStatementContext) child;
        Ast duration = builder.expressions.value(timeout.expression());
        yield new Ast.Timeout(span, duration, body(timeout.body()));
      }
      case UrbiscriptParser.RULE_stopIfStatement -> {
        var stop = (StopIfStatementContext) child;
        Ast.Condition condition = builder.events.condition(stop.condition());
        yield new Ast.StopIf(span, condition, body(stop.body()));
      }
      case UrbiscriptParser.RULE_freezeIfStatement -> {
        var freeze = (FreezeIfStatementContext) child;
        Ast.Condition condition = builder.events.condition(freeze.condition());
        yield new Ast.FreezeIf(span, condition, body(freeze.body()));
      }
      case UrbiscriptParser.RULE_tryStatement -> attempt((TryStatementContext) child);
      case UrbiscriptParser.RULE_throwStatement,
          UrbiscriptParser.RULE_returnStatement,
          UrbiscriptParser.RULE_breakStatement,
          UrbiscriptParser.RULE_continueStatement ->
          jump((ParserRuleContext) child, span);
      case UrbiscriptParser.RULE_assertStatement -> claim((AssertStatementContext) child);
      case UrbiscriptParser.RULE_classDefinition ->
          builder.functions.classDefinition((ClassDefinitionContext) child);
      case UrbiscriptParser.RULE_enumDefinition ->
          builder.functions.enumDefinition((EnumDefinitionContext) child);
      case UrbiscriptParser.RULE_packageDefinition ->
          builder.functions.packageDefinition((PackageDefinitionContext) child);
      case UrbiscriptParser.RULE_importStatement ->
          builder.functions.importStatement((ImportStatementContext) child);
      case UrbiscriptParser.RULE_externalDeclaration ->
          builder.functions.external((ExternalDeclarationContext) child);
      case UrbiscriptParser.RULE_accessor -> builder.functions.accessor((AccessorContext) child);
      default -> builder.events.emit((EmitStatementContext) child);
    };
  }

  /** A jump; in a method of its own, since the one above is on the stack once for each level. */
  private Ast jump(ParserRuleContext context, Span span) {
    if (context instanceof ThrowStatementContext raised) {
      Ast value = optional(raised.expression());
      within(value == null ? builder.enclosingCatches : 1, span, SyntaxProblem.THROW_OUTSIDE);
      return new Ast.Throw(span, value);
    }
    if (context instanceof ReturnStatementContext returned) {
      within(builder.enclosingFunctions, span, SyntaxProblem.RETURN_OUTSIDE);
      return new Ast.Return(span, optional(returned.expression()));
    }
    boolean over = context.getRuleIndex() == UrbiscriptParser.RULE_breakStatement;
    within(
        builder.enclosingLoops,
        span,
        over ? SyntaxProblem.BREAK_OUTSIDE : SyntaxProblem.CONTINUE_OUTSIDE);
    return over ? new Ast.Break(span) : new Ast.Continue(span);
  }

  private @Nullable Ast optional(ExpressionContext context) {
    return context == null ? null : builder.expressions.value(context);
  }

  private Ast expression(ExpressionStatementContext context) {
    Ast first = builder.expressions.expression(context.expression(0));
    if (context.COLON() != null) {
      return tagged(builder.span(context), first, context);
    }
    if (context.TILDE() != null) {
      Span span = builder.span(context);
      Token tilde = context.TILDE().getSymbol();
      return builder.events.lasting(span, first, tilde, context.expression(1));
    }
    return first;
  }

  /** {@code tag: statement}, but {@code var x : Type = value} is a declaration. */
  private Ast tagged(Span span, Ast tag, ExpressionStatementContext context) {
    if (!(tag instanceof Ast.Declaration declaration)) {
      return new Ast.Tagged(span, tag, body(context.body()));
    }
    if (declaration.value() != null
        || context.body().statement() == null
        || !(body(context.body()) instanceof Ast.Assignment typed)) {
      throw builder.unexpected(context.COLON().getSymbol());
    }
    return new Ast.Declaration(
        span,
        declaration.target(),
        declaration.name(),
        typed.value(),
        declaration.constant(),
        typed.target(),
        declaration.nameSpan());
  }

  private Ast conditional(IfStatementContext context) {
    return new Ast.If(
        builder.span(context),
        condition(context.sequence()),
        body(context.body(0)),
        context.ELSE() == null ? null : body(context.body(1)));
  }

  /** A list of statements as a condition: alone, a statement stands for itself. */
  private Ast condition(SequenceContext context) {
    Ast.Sequence sequence = sequence(context);
    if (sequence.statements().isEmpty()) {
      throw builder.unexpected(context.getStart());
    }
    return sequence.statements().size() == 1 ? sequence.statements().get(0) : sequence;
  }

  // ------------------------------------------------------------------------------ loops

  private Ast loopBody(BodyContext context) {
    builder.enclosingLoops++;
    try {
      return body(context);
    } finally {
      builder.enclosingLoops--;
    }
  }

  /**
   * A jump outside of what it jumps out of is an error.
   *
   * @param around how many surrounding constructs it can leave
   */
  private void within(int around, Span span, SyntaxProblem otherwise) {
    if (around == 0) {
      throw builder.failure(span, otherwise);
    }
  }

  /** The flavor of a loop, the default being {@code ;}. */
  Flavor flavor(Token keyword, FlavorContext context, @Nullable Set<Flavor> valid) {
    if (context == null) {
      return Flavor.SEMICOLON;
    }
    Token token = context.getStart();
    Flavor flavor =
        switch (token.getType()) {
          case UrbiscriptParser.SEMICOLON -> Flavor.SEMICOLON;
          case UrbiscriptParser.PIPE -> Flavor.PIPE;
          case UrbiscriptParser.COMMA -> Flavor.COMMA;
          default -> Flavor.AND;
        };
    if (valid == null ? flavor != Flavor.SEMICOLON : !valid.contains(flavor)) {
      // The deprecated "foreach" and "loopn" are "for".
      boolean loop = keyword.getType() == UrbiscriptParser.FOR;
      String name = loop ? "for" : keyword.getText();
      throw builder.failure(
          builder.span(keyword).to(builder.span(token)),
          SyntaxProblem.INVALID_FLAVOR,
          name,
          flavor.text());
    }
    return flavor;
  }

  private Ast whileLoop(WhileStatementContext context) {
    Flavor flavor = flavor(context.getStart(), context.flavor(), SEQUENTIAL_OR_BACKGROUND);
    return new Ast.While(
        builder.span(context), flavor, condition(context.sequence()), loopBody(context.body()));
  }

  private Ast loop(LoopStatementContext context) {
    Flavor flavor = flavor(context.getStart(), context.flavor(), SEQUENTIAL_OR_BACKGROUND);
    return new Ast.Loop(builder.span(context), flavor, loopBody(context.body()));
  }

  private Ast every(EveryStatementContext context) {
    Flavor flavor =
        context.flavor() == null
            ? Flavor.COMMA
            : flavor(context.getStart(), context.flavor(), SEQUENTIAL_OR_BACKGROUND);
    Ast period = builder.expressions.value(context.expression());
    return new Ast.Every(builder.span(context), flavor, period, loopBody(context.body()));
  }

  private Ast forLoop(ForStatementContext context) {
    Span span = builder.span(context);
    ForHeadContext head = context.forHead();
    boolean clauses = !head.SEMICOLON().isEmpty();
    Flavor flavor =
        flavor(
            context.getStart(),
            context.flavor(),
            clauses ? SEQUENTIAL_OR_BACKGROUND : ALL_AT_ONCE_TOO);
    if (clauses) {
      return new Ast.For(
          span,
          flavor,
          clause(head.init),
          clause(head.test),
          clause(head.step),
          loopBody(context.body()));
    }
    String name = head.name() == null ? null : TreeBuilder.text(head.name());
    Ast range = builder.expressions.value(head.expression());
    return new Ast.ForEach(span, flavor, name, range, loopBody(context.body()));
  }

  private @Nullable Ast clause(ForClauseContext context) {
    if (context == null) {
      return null;
    }
    var statements = new ArrayList<Ast>();
    var separators = new ArrayList<Flavor>();
    for (ExpressionContext expression : context.expression()) {
      if (!statements.isEmpty()) {
        separators.add(Flavor.PIPE);
      }
      statements.add(builder.expressions.expression(expression));
    }
    return statements.size() == 1
        ? statements.get(0)
        : new Ast.Sequence(builder.span(context), statements, separators);
  }

  // ------------------------------------------------------------------------------ choices

  private Ast choice(SwitchStatementContext context) {
    Ast value = condition(context.sequence());
    var cases = new ArrayList<Ast.Case>();
    for (SwitchCaseContext one : context.switchCase()) {
      Ast pattern = pattern(one.expression(0));
      Ast guard = one.IF() == null ? null : builder.expressions.value(one.expression(1));
      cases.add(new Ast.Case(builder.span(one), pattern, guard, sequence(one.sequence())));
    }
    var otherwise = context.switchDefault();
    return new Ast.Switch(
        builder.span(context),
        value,
        List.copyOf(cases),
        otherwise == null ? null : sequence(otherwise.sequence()));
  }

  private Ast pattern(ExpressionContext context) {
    return builder.literals.inPattern(() -> builder.expressions.expression(context));
  }

  private Ast attempt(TryStatementContext context) {
    Ast.Scope body = scope(context.scope());
    var catches = new ArrayList<Ast.Catch>();
    for (CatchClauseContext one : context.catchClause()) {
      Span span = builder.span(one);
      if (!catches.isEmpty() && catches.getLast().pattern() == null) {
        throw builder.failure(span, SyntaxProblem.CAUGHT_ALREADY);
      }
      Ast pattern = one.LPAREN() == null ? null : pattern(one.expression(0));
      Ast guard = one.IF() == null ? null : builder.expressions.value(one.expression(1));
      builder.enclosingCatches++;
      catches.add(new Ast.Catch(span, pattern, guard, scope(one.scope())));
      builder.enclosingCatches--;
    }
    return new Ast.Try(
        builder.span(context),
        body,
        List.copyOf(catches),
        context.elseClause() == null ? null : scope(context.elseClause().scope()),
        context.finallyClause() == null ? null : scope(context.finallyClause().scope()));
  }

  private Ast claim(AssertStatementContext context) {
    Span span = builder.span(context);
    if (context.expression() != null) {
      Ast claim = builder.expressions.value(context.expression());
      return new Ast.Assert(span, false, List.of(claim));
    }
    var claims = new ArrayList<Ast>(sequence(context.sequence()).statements());
    claims.removeIf(Ast.Noop.class::isInstance);
    return new Ast.Assert(span, true, List.copyOf(claims));
  }
}
