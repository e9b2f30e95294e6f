package org.urbi.lang.parse;

import java.util.List;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.UrbiscriptParser.AssignmentContext;
import org.urbi.lang.grammar.UrbiscriptParser.BinaryContext;
import org.urbi.lang.grammar.UrbiscriptParser.ExpressionContext;
import org.urbi.lang.grammar.UrbiscriptParser.ModifierContext;
import org.urbi.lang.grammar.UrbiscriptParser.OperandContext;
import org.urbi.lang.grammar.UrbiscriptParser.PlainContext;
import org.urbi.lang.grammar.UrbiscriptParser.PrefixContext;
import org.urbi.lang.source.Span;

/** Groups operands by the precedence of their operators (manual, "All operators summary"). */
final class ExpressionBuilder {
  private final TreeBuilder builder;

  ExpressionBuilder(TreeBuilder builder) {
    this.builder = builder;
  }

  /** An expression that may be a declaration. */
  Ast expression(ExpressionContext context) {
    if (!context.modifier().isEmpty()) {
      throw builder.unexpected(context.modifier(0).COLON().getSymbol());
    }
    return group(context, context.assignment());
  }

  /** What is assigned: the modifiers of the assignment are left aside. */
  Ast assigned(ExpressionContext context) {
    return builder.noDeclaration(group(context, context.assignment()));
  }

  /** The value of a modifier. */
  Ast plain(PlainContext context) {
    return builder.noDeclaration(group(context, null));
  }

  private Ast group(ParserRuleContext context, @Nullable AssignmentContext assignment) {
    int size = 0;
    int levels = 1;
    while (size < context.getChildCount() && grouped(context.getChild(size))) {
      levels += context.getChild(size++) instanceof OperandContext ? 0 : 1;
    }
    builder.enter(levels, context);
    Ast tree =
        size == 1
            ? builder.operands.operand((OperandContext) context.getChild(0), assignment)
            : new PrecedenceClimbing(context, size, assignment).climb(0);
    builder.leave(levels);
    return tree;
  }

  /** An expression that may not be a declaration. */
  Ast value(ExpressionContext context) {
    return builder.noDeclaration(expression(context));
  }

  private static boolean grouped(ParseTree child) {
    return !(child instanceof AssignmentContext || child instanceof ModifierContext);
  }

  /** Precedence climbing over one flat expression. */
  private final class PrecedenceClimbing {
    private final ParserRuleContext context;
    private final int size;
    private final @Nullable AssignmentContext assignment;
    private int next;

    PrecedenceClimbing(
        ParserRuleContext context, int size, @Nullable AssignmentContext assignment) {
      this.context = context;
      this.size = size;
      this.assignment = assignment;
    }

    Ast climb(int minimum) {
      int begin = TreeBuilder.begin(child(next));
      Ast left = operand();
      while (next < size) {
        Token token = child(next).getStart();
        Operators operator = Operators.binary(token.getType());
        if (operator.precedence < minimum) {
          break;
        }
        Span name = builder.span((BinaryContext) child(next++));
        left = builder.noDeclaration(left);
        Ast right =
            builder.noDeclaration(
                climb(operator.rightAssociative ? operator.precedence : operator.precedence + 1));
        Span span = builder.span(begin, end());
        left = combine(operator, span, left, right, name);
        refuseChain(operator);
      }
      return left;
    }

    private Ast operand() {
      ParserRuleContext first = child(next++);
      if (first instanceof OperandContext operand) {
        return builder.operands.operand(operand, next < size ? null : assignment);
      }
      Token token = ((PrefixContext) first).getStart();
      Operators operator = Operators.prefix(token.getType());
      Ast target = builder.noDeclaration(climb(operator.precedence));
      Span span = builder.span(token.getStartIndex(), end());
      return new Ast.Message(span, target, operator.text, List.of(), builder.span(token));
    }

    private Ast combine(Operators operator, Span span, Ast left, Ast right, Span name) {
      return switch (operator) {
        case AND -> new Ast.And(span, left, right);
        case OR -> new Ast.Or(span, left, right);
        case IN, NOT_IN -> new Ast.Message(span, right, operator.text, List.of(left), name);
        default -> new Ast.Message(span, left, operator.text, List.of(right), name);
      };
    }

    /** {@code a < b < c} has no meaning. */
    private void refuseChain(Operators operator) {
      if (operator.chainable || next >= size) {
        return;
      }
      Token token = child(next).getStart();
      if (Operators.binary(token.getType()).precedence == operator.precedence) {
        throw builder.unexpected(token);
      }
    }

    /** Where what was read so far ends: an assignment is part of the last operand. */
    private int end() {
      return TreeBuilder.end(next == size && assignment != null ? assignment : child(next - 1));
    }

    private ParserRuleContext child(int index) {
      return (ParserRuleContext) context.getChild(index);
    }
  }
}
