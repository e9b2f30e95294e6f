package org.urbi.lang.parse;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.grammar.UrbiscriptParser;
import org.urbi.lang.grammar.UrbiscriptParser.AccessorContext;
import org.urbi.lang.grammar.UrbiscriptParser.ClassDefinitionContext;
import org.urbi.lang.grammar.UrbiscriptParser.EnumDefinitionContext;
import org.urbi.lang.grammar.UrbiscriptParser.ExpressionContext;
import org.urbi.lang.grammar.UrbiscriptParser.ExternalDeclarationContext;
import org.urbi.lang.grammar.UrbiscriptParser.FormalContext;
import org.urbi.lang.grammar.UrbiscriptParser.FormalsContext;
import org.urbi.lang.grammar.UrbiscriptParser.FunctionContext;
import org.urbi.lang.grammar.UrbiscriptParser.ImportStatementContext;
import org.urbi.lang.grammar.UrbiscriptParser.NameContext;
import org.urbi.lang.grammar.UrbiscriptParser.PackageDefinitionContext;
import org.urbi.lang.grammar.UrbiscriptParser.PathContext;
import org.urbi.lang.grammar.UrbiscriptParser.PostfixContext;
import org.urbi.lang.grammar.UrbiscriptParser.ProtosContext;
import org.urbi.lang.grammar.UrbiscriptParser.ScopeContext;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Span;

/** What defines names: functions, classes, packages (manual, "Functions", "Pseudo classes"). */
final class FunctionBuilder {
  private final TreeBuilder builder;

  FunctionBuilder(TreeBuilder builder) {
    this.builder = builder;
  }

  Ast function(FunctionContext context) {
    Span span = builder.span(context);
    boolean closure = context.CLOSURE() != null;
    if (closure && context.formals() == null) {
      throw builder.failure(span, SyntaxProblem.LAZY_CLOSURE);
    }
    Ast.Message name = context.path() == null ? null : path(context.path());
    Ast.Function function =
        new Ast.Function(span, closure, formals(context.formals()), body(context.scope(), closure));
    return name == null ? function : new Ast.FunctionDefinition(span, name, function);
  }

  Ast accessor(AccessorContext context) {
    Span span = builder.span(context);
    Ast.Message name = path(context.path());
    var function =
        new Ast.Function(span, false, formals(context.formals()), body(context.scope(), false));
    return new Ast.Accessor(span, context.SET() != null, name, function);
  }

  private Ast.Scope body(ScopeContext context, boolean closure) {
    builder.enclosingFunctions++;
    int loops = builder.enclosingLoops;
    int catches = builder.enclosingCatches;
    builder.enclosingCatches = 0;
    // A closure may be what a loop calls.
    builder.enclosingLoops = closure ? 1 : 0;
    try {
      return builder.statements.scope(context);
    } finally {
      builder.enclosingFunctions--;
      builder.enclosingLoops = loops;
      builder.enclosingCatches = catches;
    }
  }

  private @Nullable List<Ast.Formal> formals(FormalsContext context) {
    if (context == null) {
      return null;
    }
    var formals = new ArrayList<Ast.Formal>();
    for (FormalContext one : context.formal()) {
      Ast.Formal last = formals.isEmpty() ? null : formals.getLast();
      Ast.Formal formal = formal(one);
      if (last != null && last.variadic()) {
        throw builder.failure(formal.span(), SyntaxProblem.ARGUMENT_AFTER_LIST);
      }
      if (last != null
          && last.defaultValue() != null
          && formal.defaultValue() == null
          && !formal.variadic()) {
        throw builder.failure(builder.span(context), SyntaxProblem.ARGUMENT_WITHOUT_DEFAULT);
      }
      formals.add(formal);
    }
    return List.copyOf(formals);
  }

  private Ast.Formal formal(FormalContext context) {
    ExpressionContext value = context.expression();
    PostfixContext type = context.postfix();
    return new Ast.Formal(
        builder.span(context),
        TreeBuilder.text(context.name()),
        value == null ? null : builder.expressions.value(value),
        context.LBRACKET() != null,
        type == null ? null : builder.operands.postfix(type));
  }

  Ast classDefinition(ClassDefinitionContext context) {
    return new Ast.ClassDefinition(
        builder.span(context),
        lvalue(context.postfix()),
        protos(context.protos()),
        context.scope() == null ? null : builder.statements.slots(context.scope()));
  }

  Ast packageDefinition(PackageDefinitionContext context) {
    Span span = builder.span(context);
    Ast.Message name = path(context.path());
    Ast.Scope body = builder.statements.slots(context.scope());
    // A package with prototypes is a class in a package: "package lang.Point : Serializable {}".
    return context.protos() == null
        ? new Ast.PackageDefinition(span, name, body)
        : new Ast.ClassDefinition(span, name, protos(context.protos()), body);
  }

  private List<Ast> protos(ProtosContext context) {
    if (context == null) {
      return List.of();
    }
    var protos = new ArrayList<Ast>();
    for (ExpressionContext proto : context.expression()) {
      protos.add(builder.expressions.value(proto));
    }
    return List.copyOf(protos);
  }

  Ast enumDefinition(EnumDefinitionContext context) {
    var values = new ArrayList<String>();
    for (NameContext name : context.name()) {
      values.add(TreeBuilder.text(name));
    }
    return new Ast.EnumDefinition(
        builder.span(context), lvalue(context.postfix()), List.copyOf(values));
  }

  Ast importStatement(ImportStatementContext context) {
    var path = new ArrayList<String>();
    if (context.path().THIS() != null) {
      path.add("this");
    }
    for (NameContext name : context.path().name()) {
      path.add(TreeBuilder.text(name));
    }
    return new Ast.Import(builder.span(context), List.copyOf(path), context.TIMES() != null);
  }

  /** A message named {@code external}: the kind, the arity if any, the name, the component. */
  Ast external(ExternalDeclarationContext context) {
    Span span = builder.span(context);
    var arguments = new ArrayList<Ast>();
    for (ParseTree child : context.children) {
      if (child instanceof PathContext path) {
        arguments.add(new Ast.StringLiteral(builder.span(path), path.getText()));
      } else if (child instanceof TerminalNode node) {
        Token token = node.getSymbol();
        boolean kind = arguments.isEmpty() && token.getType() != UrbiscriptParser.EXTERNAL;
        if (kind || token.getType() == UrbiscriptParser.NUMBER) {
          arguments.add(new Ast.StringLiteral(builder.span(token), token.getText()));
        }
      }
    }
    return new Ast.Message(
        span, null, "external", List.copyOf(arguments), builder.span(context.getStart()));
  }

  private Ast.Message lvalue(PostfixContext context) {
    return builder.operands.lvalue(builder.span(context), builder.operands.postfix(context));
  }

  private Ast.Message path(PathContext context) {
    return builder.operands.lvalue(builder.span(context), pathExpression(context));
  }

  /** {@code a.b.c} as a chain of messages. */
  Ast pathExpression(PathContext context) {
    List<NameContext> names = context.name();
    builder.enter(names.size(), context);
    builder.leave(names.size());
    Ast tree = context.THIS() == null ? null : new Ast.This(builder.span(context.getStart()));
    for (NameContext name : names) {
      Span span = builder.span(TreeBuilder.begin(context), TreeBuilder.end(name));
      tree = new Ast.Message(span, tree, TreeBuilder.text(name), null, builder.span(name));
    }
    return requireNonNull(tree, "a path has at least one name");
  }
}
