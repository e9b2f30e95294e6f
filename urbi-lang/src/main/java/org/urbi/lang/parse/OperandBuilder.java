package org.urbi.lang.parse;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.grammar.UrbiscriptParser.ArgumentsContext;
import org.urbi.lang.grammar.UrbiscriptParser.AssignmentContext;
import org.urbi.lang.grammar.UrbiscriptParser.DeclarationContext;
import org.urbi.lang.grammar.UrbiscriptParser.ExpressionContext;
import org.urbi.lang.grammar.UrbiscriptParser.ModifierContext;
import org.urbi.lang.grammar.UrbiscriptParser.NameContext;
import org.urbi.lang.grammar.UrbiscriptParser.OperandContext;
import org.urbi.lang.grammar.UrbiscriptParser.PostfixContext;
import org.urbi.lang.grammar.UrbiscriptParser.SuffixContext;
import org.urbi.lang.print.Printer;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Span;

/** Declarations, assignments, and chains of messages (manual, "Assignment", "Sending messages"). */
final class OperandBuilder {
  private final TreeBuilder builder;

  OperandBuilder(TreeBuilder builder) {
    this.builder = builder;
  }

  /** An operand, and what is assigned to it if anything. */
  Ast operand(OperandContext context, @Nullable AssignmentContext assignment) {
    if (context.declaration() != null) {
      Ast.Declaration declaration = declaration(context.declaration());
      return assignment == null ? declaration : initialize(declaration, assignment);
    }
    if (assignment == null) {
      return postfix(context.postfix());
    }
    Token operator = assignment.getStart();
    boolean plain = assignment.ASSIGN() != null;
    Ast target =
        plain
            ? builder.literals.inPattern(() -> postfix(context.postfix()))
            : postfix(context.postfix());
    check(target, builder.span(context.postfix()), plain);
    Span span = builder.span(context).to(builder.span(assignment));
    if (plain) {
      return assign(span, target, assignment);
    }
    String text = operator.getType() == UrbiscriptParser.XOR_ASSIGN ? "^=" : operator.getText();
    return new Ast.OperatorAssignment(span, target, text, value(assignment.expression()));
  }

  private void check(Ast target, Span span, boolean pattern) {
    boolean fine =
        target instanceof Ast.Message m
            ? pattern || m.arguments() == null || m.name().equals("[]")
            : target instanceof Ast.Property
                || pattern && !(target instanceof Ast.SlotAccess || target instanceof Ast.Emit);
    if (!fine) {
      throw builder.notAnLvalue(span, target);
    }
  }

  private Ast assign(Span span, Ast target, AssignmentContext assignment) {
    List<ModifierContext> modifiers = modifiersOf(assignment);
    if (modifiers.isEmpty()) {
      return new Ast.Assignment(span, target, value(assignment.expression()));
    }
    Ast value = assignment.expression() == null ? null : value(assignment.expression());
    return new Ast.Trajectory(span, target, value, modifiers(modifiers));
  }

  private Ast initialize(Ast.Declaration declaration, AssignmentContext assignment) {
    if (assignment.ASSIGN() == null) {
      throw builder.unexpected(assignment.getStart());
    }
    Span span = declaration.span().to(builder.span(assignment));
    if (!modifiersOf(assignment).isEmpty()) {
      if (assignment.expression() == null) {
        throw builder.declarationNotAllowed(declaration);
      }
      return assign(span, declaration, assignment);
    }
    return new Ast.Declaration(
        span,
        declaration.target(),
        declaration.name(),
        value(assignment.expression()),
        declaration.constant(),
        null,
        declaration.nameSpan());
  }

  private Ast value(ExpressionContext expression) {
    return builder.literals.outsidePattern(() -> builder.expressions.assigned(expression));
  }

  private static List<ModifierContext> modifiersOf(AssignmentContext assignment) {
    ExpressionContext value = assignment.expression();
    return value == null ? assignment.modifier() : value.modifier();
  }

  private List<Ast.Modifier> modifiers(List<ModifierContext> contexts) {
    var modifiers = new ArrayList<Ast.Modifier>();
    var seen = new HashSet<String>();
    for (ModifierContext context : contexts) {
      String name = TreeBuilder.text(context.name());
      Ast value = builder.literals.outsidePattern(() -> builder.expressions.plain(context.plain()));
      if (!seen.add(name)) {
        builder.warn(builder.span(context), SyntaxProblem.MODIFIER_REDEFINED, name);
        modifiers.removeIf(modifier -> modifier.name().equals(name));
      }
      modifiers.add(new Ast.Modifier(name, value));
    }
    return List.copyOf(modifiers);
  }

  private Ast.Declaration declaration(DeclarationContext context) {
    Ast target = builder.literals.outsidePattern(() -> postfix(context.postfix()));
    Ast.Message name = lvalue(builder.span(context.postfix()), target);
    return new Ast.Declaration(
        builder.span(context),
        name.target(),
        name.name(),
        null,
        context.CONST() != null,
        null,
        name.nameSpan());
  }

  /** The name that something is given by a declaration: {@code a.b.c}. */
  Ast.Message lvalue(Span span, Ast target) {
    if (target instanceof Ast.Message message && message.arguments() == null) {
      return message;
    }
    throw builder.notAnLvalue(span, target);
  }

  Ast postfix(PostfixContext context) {
    List<SuffixContext> suffixes = context.suffix();
    builder.enter(suffixes.size(), context);
    Ast tree = builder.literals.primary(context.primary());
    boolean name = context.primary().identifier() != null || context.primary().NEW() != null;
    for (SuffixContext suffix : suffixes) {
      Span span = builder.span(TreeBuilder.begin(context), TreeBuilder.end(suffix));
      tree = suffix(span, tree, suffix, name);
      name = false;
    }
    builder.leave(suffixes.size());
    return tree;
  }

  private Ast suffix(Span span, Ast target, SuffixContext context, boolean name) {
    int operator = context.getStart().getType();
    switch (operator) {
      case UrbiscriptParser.DOT -> {
        return new Ast.Message(
            span,
            target,
            TreeBuilder.text(context.name()),
            context.arguments() == null ? null : arguments(context.arguments()),
            builder.span(context.name()));
      }
      case UrbiscriptParser.DOT_AND -> {
        return new Ast.SlotAccess(span, target, TreeBuilder.text(context.name()));
      }
      case UrbiscriptParser.ARROW -> {
        return property(span, target, context.name());
      }
      case UrbiscriptParser.INCREMENT, UrbiscriptParser.DECREMENT -> {
        check(target, target.span(), false);
        return new Ast.Postfix(span, target, context.getText());
      }
      case UrbiscriptParser.DERIVED -> {
        return derived(span, target, context);
      }
      case UrbiscriptParser.LBRACKET -> {
        Span brackets = builder.span(context);
        return new Ast.Message(span, target, "[]", values(context.expression()), brackets);
      }
      case UrbiscriptParser.BANG -> {
        List<Ast> arguments = context.arguments() == null ? null : arguments(context.arguments());
        return new Ast.Emit(span, target, arguments, null);
      }
      default -> {
        List<Ast> arguments = arguments(context.arguments());
        if (name && target instanceof Ast.Message m && m.arguments() == null) {
          return new Ast.Message(span, m.target(), m.name(), arguments, m.nameSpan());
        }
        return new Ast.Message(span, target, "()", arguments, builder.span(context));
      }
    }
  }

  /** {@code x'd}, the old way to write {@code x.'\'d'}. */
  private Ast derived(Span span, Ast target, SuffixContext context) {
    String name = context.getText();
    var tree = new Ast.Message(span, target, name, null, builder.span(context));
    boolean plain = List.of("'n", "'in", "'out").contains(name);
    builder.warn(
        span,
        plain ? SyntaxProblem.DEPRECATED_FOR : SyntaxProblem.DEPRECATED_DERIVATIVE,
        span.text(),
        Printer.print(tree));
    return tree;
  }

  private Ast property(Span span, Ast target, NameContext name) {
    if (target instanceof Ast.Message message && message.arguments() == null) {
      return new Ast.Property(span, message.target(), message.name(), TreeBuilder.text(name));
    }
    throw builder.notAnLvalue(target.span(), target);
  }

  List<Ast> arguments(ArgumentsContext context) {
    return values(context.expression());
  }

  private List<Ast> values(List<ExpressionContext> contexts) {
    return builder.literals.outsidePattern(() -> {
      var values = new ArrayList<Ast>(contexts.size());
      for (ExpressionContext context : contexts) {
        values.add(builder.expressions.value(context));
      }
      return List.copyOf(values);
    });
  }
}
