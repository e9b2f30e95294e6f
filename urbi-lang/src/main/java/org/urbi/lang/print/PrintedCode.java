package org.urbi.lang.print;

import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.AstVisitor;

/**
 * Code that is being printed: how each kind of node is written to it.
 *
 * <p>It only selects the printer: a single method that distinguishes and prints all kinds would
 * need so much stack that deep trees could not be printed on the threads that have parsed them.
 *
 * <p>What the methods return means nothing. It is an {@code Object} because for any other type the
 * compiler adds a second method to each, which only calls it: one more frame on each level.
 */
final class PrintedCode extends Text implements AstVisitor<Object> {
  @Override
  public Object visit(Ast.FloatLiteral node) {
    add(FloatFormat.format(node.value()));
    return this;
  }

  @Override
  public Object visit(Ast.StringLiteral node) {
    quote(node.value());
    return this;
  }

  @Override
  public Object visit(Ast.ListLiteral node) {
    Expressions.list(node.elements(), this);
    return this;
  }

  @Override
  public Object visit(Ast.TupleLiteral node) {
    Expressions.tuple(node.elements(), this);
    return this;
  }

  @Override
  public Object visit(Ast.DictionaryLiteral node) {
    Expressions.dictionary(node.entries(), this);
    return this;
  }

  @Override
  public Object visit(Ast.This node) {
    add("this");
    return this;
  }

  @Override
  public Object visit(Ast.CallMessage node) {
    add("call");
    return this;
  }

  @Override
  public Object visit(Ast.Message node) {
    Expressions.message(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.And node) {
    Expressions.and(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Or node) {
    Expressions.or(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.SlotAccess node) {
    Expressions.slot(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Property node) {
    Expressions.property(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Declaration node) {
    Expressions.declaration(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Assignment node) {
    Expressions.assign(node.target(), "=", node.value(), this);
    return this;
  }

  @Override
  public Object visit(Ast.OperatorAssignment node) {
    Expressions.assign(node.target(), node.operator(), node.value(), this);
    return this;
  }

  @Override
  public Object visit(Ast.Postfix node) {
    Expressions.postfix(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Trajectory node) {
    Expressions.trajectory(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Function node) {
    Expressions.function(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.FunctionDefinition node) {
    Definitions.function(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Accessor node) {
    Definitions.accessor(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.ClassDefinition node) {
    Definitions.classDefinition(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.PackageDefinition node) {
    Definitions.packageDefinition(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Import node) {
    Definitions.importStatement(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.EnumDefinition node) {
    Definitions.enumDefinition(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Sequence node) {
    Statements.sequence(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Scope node) {
    Statements.scope(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Do node) {
    Statements.doBlock(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Noop node) {
    return this;
  }

  @Override
  public Object visit(Ast.If node) {
    Statements.conditional(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.While node) {
    Statements.loop(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.For node) {
    Statements.loop(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.ForEach node) {
    Statements.loop(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Loop node) {
    Statements.loop(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Switch node) {
    Statements.choice(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Return node) {
    Statements.leave("return", node.value(), this);
    return this;
  }

  @Override
  public Object visit(Ast.Break node) {
    add("break");
    return this;
  }

  @Override
  public Object visit(Ast.Continue node) {
    add("continue");
    return this;
  }

  @Override
  public Object visit(Ast.Throw node) {
    Statements.leave("throw", node.value(), this);
    return this;
  }

  @Override
  public Object visit(Ast.Try node) {
    Statements.attempt(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Assert node) {
    Statements.claim(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Tagged node) {
    Statements.tagged(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.At node) {
    Events.at(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Whenever node) {
    Events.whenever(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.WaitUntil node) {
    Events.waitUntil(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Watch node) {
    Expressions.watch(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Emit node) {
    Events.emission(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Every node) {
    Statements.loop(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.Timeout node) {
    Statements.timeout(node, this);
    return this;
  }

  @Override
  public Object visit(Ast.StopIf node) {
    Events.conditional("stopif ", node.condition(), node.body(), this);
    return this;
  }

  @Override
  public Object visit(Ast.FreezeIf node) {
    Events.conditional("freezeif ", node.condition(), node.body(), this);
    return this;
  }
}
