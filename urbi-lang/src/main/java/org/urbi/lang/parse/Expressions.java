package org.urbi.lang.parse;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.UrbiLexer;
import org.urbi.lang.grammar.UrbiParser.*;
import org.urbi.lang.print.Printer;
import org.urbi.lang.source.Span;

/** Trees of expressions. */
final class Expressions {
  /** How deep trees may be: they are walked recursively. */
  private static final int LIMIT = 1000;

  /** Thrown by a tree that would be too deep. */
  static final class TooLong extends RuntimeException {
    private static final long serialVersionUID = 1;
    private final transient Span span;

    TooLong(Span span) {
      super("nesting too deep", null, false, false);
      this.span = span;
    }

    Span span() {
      return span;
    }
  }

  private final Errors errors;
  private final Statements statements;
  private final Primaries primaries;

  /** How deep the tree is where it grows. */
  private int depth;

  /** Positive inside a pattern, where {@code var x} binds. */
  private int patterns;

  Expressions(Errors errors, Statements statements) {
    this.errors = errors;
    this.statements = statements;
    this.primaries = new Primaries(errors, statements, this);
  }

  Primaries primaries() {
    return primaries;
  }

  /** An expression whose value is wanted: no bare declaration, unless in a pattern. */
  Ast value(ExpressionContext context) {
    return checked(expression(context));
  }

  /** A pattern: declarations bind. */
  Ast pattern(ExpressionContext context) {
    patterns++;
    Ast pattern = expression(context);
    patterns--;
    return pattern;
  }

  /** Any expression. Chains to the left are followed without recursion. */
  Ast expression(ExpressionContext context) {
    Deque<ExpressionContext> chain = new ArrayDeque<>();
    ExpressionContext at = context;
    while (at.getChild(0) instanceof ExpressionContext left) {
      chain.push(at);
      at = left;
    }
    deeper(chain.size() + 1, context);
    boolean target = chain.stream().anyMatch(AssignmentContext.class::isInstance);
    if (target) {
      patterns++;
    }
    Ast tree = leaf(at);
    while (!chain.isEmpty()) {
      ExpressionContext next = chain.pop();
      if (target && next instanceof AssignmentContext) {
        patterns--;
        target = false;
      }
      tree = combine(next, tree);
      depth--;
    }
    depth--;
    return tree;
  }

  /** Goes down (or up) in the tree. */
  void deeper(int levels, ParserRuleContext context) {
    depth += levels;
    if (depth > LIMIT) {
      throw new TooLong(errors.span(context.getStart()));
    }
  }

  private Ast leaf(ExpressionContext context) {
    return switch (context) {
      case UnaryExpressionContext unary -> {
        Span name = errors.span(unary.op);
        yield new Ast.Message(
            errors.span(context), value(unary.expression()), operator(unary.op), List.of(), name);
      }
      case PrefixExpressionContext prefix -> {
        Ast target = expression(prefix.expression());
        lvalue(target);
        Span one = errors.span(prefix.op);
        yield new Ast.OperatorAssignment(
            errors.span(context),
            target,
            prefix.op.getType() == UrbiLexer.INCREMENT ? "+=" : "-=",
            new Ast.FloatLiteral(one, 1));
      }
      case PrimaryExpressionContext primary -> primaries.primary(primary.primary());
      default -> throw new IllegalStateException(context.getText());
    };
  }

  private Ast combine(ExpressionContext context, Ast left) {
    Span span = errors.span(context);
    if (!(context instanceof AssignmentContext)) {
      checked(left);
    }
    return switch (context) {
      case SlotExpressionContext slot -> primaries.slot(span, left, slot.selector().getStart());
      case AccessExpressionContext access ->
          new Ast.SlotAccess(span, left, Literals.name(access.selector().getStart()));
      case PropertyExpressionContext property -> property(property, left, span);
      case CallExpressionContext call -> call(call, left, span);
      case SubscriptExpressionContext subscript ->
          new Ast.Message(
              span,
              left,
              "[]",
              arguments(subscript.argumentList()),
              errors.span(subscript.LBRACKET().getSymbol(), subscript.RBRACKET().getSymbol()));
      case PostfixExpressionContext postfix -> {
        lvalue(left);
        yield new Ast.Postfix(span, left, postfix.op.getText());
      }
      case EmitExpressionContext emit ->
          new Ast.Emit(
              span,
              left,
              emit.arguments() == null ? null : arguments(emit.arguments().argumentList()),
              emit.expression().size() < 2 ? null : value(emit.expression(1)));
      case BinaryExpressionContext binary -> binary(span, left, binary.op, binary.expression(1));
      case ComparisonContext comparison ->
          binary(span, left, comparison.op, comparison.expression(1));
      case MembershipContext membership -> membership(membership, left, span);
      case ConjunctionContext and -> new Ast.And(span, left, value(and.expression(1)));
      case DisjunctionContext or -> new Ast.Or(span, left, value(or.expression(1)));
      case AssignmentContext assignment -> assignment(assignment, left, span);
      case OperatorAssignmentContext assignment -> {
        lvalue(left);
        String operator = assignment.op.getText();
        yield new Ast.OperatorAssignment(
            span,
            left,
            operator.equals("xor_eq") ? "^=" : operator,
            value(assignment.expression(1)));
      }
      case EventExpressionContext event -> {
        errors.add(errors.span(event.QUESTION().getSymbol()), "unexpected ?");
        yield left;
      }
      default -> throw new IllegalStateException(context.getText());
    };
  }

  private Ast property(PropertyExpressionContext context, Ast left, Span span) {
    String name = Literals.name(context.selector().getStart());
    if (left instanceof Ast.Message message && message.arguments() == null) {
      return new Ast.Property(span, message.target(), message.name(), name);
    }
    errors.add(errors.span(context.ARROW().getSymbol()), "unexpected ->");
    return left;
  }

  private Ast call(CallExpressionContext context, Ast left, Span span) {
    List<Ast> arguments = arguments(context.arguments().argumentList());
    ExpressionContext callee = context.expression();
    boolean named =
        callee instanceof SlotExpressionContext
            || callee instanceof PrimaryExpressionContext primary
                && (primary.primary() instanceof NamePrimaryContext);
    if (named && left instanceof Ast.Message message) {
      return new Ast.Message(span, message.target(), message.name(), arguments, message.nameSpan());
    }
    return new Ast.Message(span, left, "()", arguments, errors.span(context.arguments()));
  }

  private Ast binary(Span span, Ast left, Token operator, ExpressionContext right) {
    return new Ast.Message(
        span, left, operator(operator), List.of(value(right)), errors.span(operator));
  }

  private Ast membership(MembershipContext context, Ast left, Span span) {
    nonAssociative(context.expression(0), context.IN().getSymbol());
    Token first = context.BANG() == null ? context.IN().getSymbol() : context.BANG().getSymbol();
    return new Ast.Message(
        span,
        value(context.expression(1)),
        context.BANG() == null ? "has" : "hasNot",
        List.of(left),
        errors.span(first, context.IN().getSymbol()));
  }

  private void nonAssociative(ExpressionContext left, Token operator) {
    if (left instanceof MembershipContext) {
      errors.add(errors.span(operator), "unexpected " + operator.getText());
    }
  }

  private Ast assignment(AssignmentContext context, Ast left, Span span) {
    // Anything may be assigned to: it is a pattern then.
    List<Ast.Modifier> modifiers = new ArrayList<>();
    for (ModifierContext modifier : context.modifier()) {
      modifiers.add(new Ast.Modifier(modifier.MODIFIER().getText(), value(modifier.expression())));
    }
    Ast value = context.expression().size() < 2 ? null : value(context.expression(1));
    if (value instanceof Ast.Declaration declaration) {
      misplaced(declaration);
    }
    return modifiers.isEmpty()
        ? new Ast.Assignment(span, left, value)
        : new Ast.Trajectory(span, left, value, List.copyOf(modifiers));
  }

  /** Reports what cannot be assigned to. */
  private void lvalue(Ast target) {
    boolean good =
        switch (target) {
          case Ast.Message m ->
              m.name().equals("[]")
                  || m.arguments() == null && !(m.target() == null && m.name().isEmpty());
          case Ast.Property p -> true;
          case Ast.ListLiteral l -> true;
          case Ast.TupleLiteral t -> true;
          case Ast.DictionaryLiteral d -> true;
          default -> false;
        };
    if (!good) {
      errors.add(target.span(), Printer.print(target) + " is not a valid lvalue");
    }
  }

  private Ast checked(Ast ast) {
    if (patterns == 0
        && ast instanceof Ast.Declaration declaration
        && declaration.value() == null) {
      misplaced(declaration);
    }
    return ast;
  }

  /** Reports a declaration where there may be none. */
  void misplaced(Ast.Declaration declaration) {
    Span span = declaration.span();
    errors.add(
        errors.span(span.begin(), Math.max(span.begin(), declaration.nameSpan().end())),
        "declaration not allowed here");
  }

  List<Ast> arguments(ArgumentListContext context) {
    return context == null ? List.of() : context.argument().stream().map(this::argument).toList();
  }

  /** The patterns of an event's payload. */
  List<Ast> patterns(ArgumentsContext context) {
    patterns++;
    List<Ast> found = arguments(context.argumentList());
    patterns--;
    return found;
  }

  /** An expression, or a tagged statement. */
  Ast argument(ArgumentContext context) {
    Ast value = value(context.expression());
    if (context.COLON() == null) {
      return value;
    }
    int outer = patterns;
    patterns = 0;
    Ast tagged = statements.tagged(errors.span(context), value, context.body(), context.COLON());
    patterns = outer;
    return tagged;
  }

  /** Statements inside an expression are no patterns. */
  <T> T outside(java.util.function.Supplier<T> build) {
    int outer = patterns;
    patterns = 0;
    T built = build.get();
    patterns = outer;
    return built;
  }

  private static final Set<Integer> WORDS =
      Set.of(UrbiLexer.CARET, UrbiLexer.NOT_EQUAL, UrbiLexer.BANG);

  private static String operator(Token token) {
    if (!WORDS.contains(token.getType())) {
      return token.getText();
    }
    return switch (token.getType()) {
      case UrbiLexer.CARET -> "^";
      case UrbiLexer.NOT_EQUAL -> "!=";
      default -> "!";
    };
  }
}
