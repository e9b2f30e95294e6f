package org.urbi.lang.parse;

import java.util.List;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.Checkpoint;
import org.urbi.lang.grammar.UrbiToken;
import org.urbi.lang.grammar.UrbiscriptParser.IdentifierContext;
import org.urbi.lang.grammar.UrbiscriptParser.NameContext;
import org.urbi.lang.print.Printer;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;

/** The common part of the builders that turn parse trees into syntax trees. */
final class TreeBuilder {
  /** The height limit of a tree, because later passes walk it recursively. */
  static final int MAXIMUM_HEIGHT = 1500;

  final StatementBuilder statements = new StatementBuilder(this);
  final EventBuilder events = new EventBuilder(this);
  final ExpressionBuilder expressions = new ExpressionBuilder(this);
  final OperandBuilder operands = new OperandBuilder(this);
  final LiteralBuilder literals = new LiteralBuilder(this);
  final FunctionBuilder functions = new FunctionBuilder(this);

  /** How many function bodies are around: {@code call} has no meaning outside of them. */
  int enclosingFunctions;

  /** How many loops are around, in the function that is being built. */
  int enclosingLoops;

  /** How many catch clauses are around, in the function that is being built. */
  int enclosingCatches;

  private final Source source;
  private final List<SyntaxWarning> warnings;
  private final Checkpoint checkpoint;
  private int height;

  TreeBuilder(Source source, List<SyntaxWarning> warnings, Checkpoint checkpoint) {
    this.source = source;
    this.checkpoint = checkpoint;
    this.warnings = warnings;
  }

  /** Increases the depth until {@link #leave}. */
  void enter(int levels, ParserRuleContext context) {
    checkpoint.pass();
    height += levels;
    if (height > MAXIMUM_HEIGHT) {
      throw failure(TokenNames.span(source, context.getStart()), SyntaxProblem.NESTING_TOO_DEEP);
    }
  }

  void leave(int levels) {
    height -= levels;
  }

  Span span(ParserRuleContext context) {
    int begin = begin(context);
    Token stop = context.getStop();
    return new Span(source, begin, stop == null ? begin : Math.max(begin, end(context)));
  }

  Span span(Token token) {
    return TokenNames.span(source, token);
  }

  Span span(int begin, int end) {
    return new Span(source, begin, end);
  }

  static int begin(ParserRuleContext context) {
    return context.getStart().getStartIndex();
  }

  static int end(ParserRuleContext context) {
    return context.getStop().getStopIndex() + 1;
  }

  static String text(NameContext name) {
    return ((UrbiToken) name.getStart()).string();
  }

  static String text(IdentifierContext identifier) {
    return ((UrbiToken) identifier.getStart()).string();
  }

  SyntaxErrorException failure(Span span, SyntaxProblem problem, Object... values) {
    return new SyntaxErrorException(span, problem, values);
  }

  SyntaxErrorException unexpected(Token token) {
    return TokenNames.unexpected(source, token);
  }

  SyntaxErrorException notAnLvalue(Span span, Ast tree) {
    return failure(span, SyntaxProblem.NOT_AN_LVALUE, Printer.print(tree));
  }

  void warn(Span span, SyntaxProblem problem, Object... values) {
    warnings.add(new SyntaxWarning(span, problem, problem.text(values)));
  }

  /** The value, which must not be a declaration. */
  Ast noDeclaration(Ast tree) {
    if (tree instanceof Ast.Declaration declaration) {
      throw declarationNotAllowed(declaration);
    }
    return tree;
  }

  SyntaxErrorException declarationNotAllowed(Ast.Declaration declaration) {
    Span head =
        declaration.span().begin() <= declaration.nameSpan().begin()
            ? declaration.span().to(declaration.nameSpan())
            : declaration.span();
    return failure(head, SyntaxProblem.MISPLACED_DECLARATION);
  }
}
