package org.urbi.lang.print;

import java.util.function.Supplier;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.AstVisitor;

/**
 * How each kind of node is printed.
 *
 * <p>It only selects the printer: a single method that distinguishes and prints all kinds would
 * need so much stack that deep trees could not be printed on the threads that have parsed them.
 */
final class NodePrinters implements AstVisitor<NodePrinters.Form> {
  private static final NodePrinters FORMS = new NodePrinters();

  /** How tight a node binds. */
  enum Binding {
    /** Needs braces where a value is expected. */
    STATEMENT,
    /** Needs parentheses where a message is sent to it. */
    LOOSE,
    TIGHT
  }

  /** The text of a node, made when it is asked for. */
  record Form(Binding binding, Supplier<String> text) {}

  private NodePrinters() {}

  static Form of(Ast tree) {
    return tree.accept(FORMS);
  }

  private static Form statement(Supplier<String> text) {
    return new Form(Binding.STATEMENT, text);
  }

  private static Form loose(Supplier<String> text) {
    return new Form(Binding.LOOSE, text);
  }

  private static Form tight(Supplier<String> text) {
    return new Form(Binding.TIGHT, text);
  }

  @Override
  public Form visit(Ast.FloatLiteral node) {
    Supplier<String> text = () -> FloatFormat.format(node.value());
    return node.value() >= 0 ? tight(text) : loose(text);
  }

  @Override
  public Form visit(Ast.StringLiteral node) {
    return tight(() -> StringEscape.quote(node.value()));
  }

  @Override
  public Form visit(Ast.ListLiteral node) {
    return tight(() -> Expressions.list(node.elements()));
  }

  @Override
  public Form visit(Ast.TupleLiteral node) {
    return tight(() -> Expressions.tuple(node.elements()));
  }

  @Override
  public Form visit(Ast.DictionaryLiteral node) {
    return tight(() -> Expressions.dictionary(node.entries()));
  }

  @Override
  public Form visit(Ast.This node) {
    return tight(() -> "this");
  }

  @Override
  public Form visit(Ast.CallMessage node) {
    return tight(() -> "call");
  }

  @Override
  public Form visit(Ast.Message node) {
    return tight(() -> Expressions.message(node));
  }

  @Override
  public Form visit(Ast.And node) {
    return loose(() -> Expressions.and(node));
  }

  @Override
  public Form visit(Ast.Or node) {
    return loose(() -> Expressions.or(node));
  }

  @Override
  public Form visit(Ast.SlotAccess node) {
    return tight(() -> Expressions.slot(node));
  }

  @Override
  public Form visit(Ast.Property node) {
    return tight(() -> Expressions.property(node));
  }

  @Override
  public Form visit(Ast.Declaration node) {
    return loose(() -> Expressions.declaration(node));
  }

  @Override
  public Form visit(Ast.Assignment node) {
    return loose(() -> Expressions.assign(node.target(), "=", node.value()));
  }

  @Override
  public Form visit(Ast.OperatorAssignment node) {
    return loose(() -> Expressions.assign(node.target(), node.operator(), node.value()));
  }

  @Override
  public Form visit(Ast.Postfix node) {
    return tight(() -> Expressions.lvalue(node.target()).concat(node.operator()));
  }

  @Override
  public Form visit(Ast.Trajectory node) {
    return loose(() -> Expressions.trajectory(node));
  }

  @Override
  public Form visit(Ast.Function node) {
    return tight(() -> Expressions.function(node));
  }

  @Override
  public Form visit(Ast.FunctionDefinition node) {
    return tight(() -> Definitions.function(node));
  }

  @Override
  public Form visit(Ast.Accessor node) {
    return statement(() -> Definitions.accessor(node));
  }

  @Override
  public Form visit(Ast.ClassDefinition node) {
    return statement(() -> Definitions.classDefinition(node));
  }

  @Override
  public Form visit(Ast.PackageDefinition node) {
    return statement(() -> Definitions.packageDefinition(node));
  }

  @Override
  public Form visit(Ast.Import node) {
    return statement(() -> Definitions.importStatement(node));
  }

  @Override
  public Form visit(Ast.EnumDefinition node) {
    return statement(() -> Definitions.enumDefinition(node));
  }

  @Override
  public Form visit(Ast.Sequence node) {
    return statement(() -> Statements.sequence(node));
  }

  @Override
  public Form visit(Ast.Scope node) {
    return tight(() -> Statements.scope(node));
  }

  @Override
  public Form visit(Ast.Do node) {
    return tight(() -> Statements.doBlock(node));
  }

  @Override
  public Form visit(Ast.Noop node) {
    return statement(() -> "");
  }

  @Override
  public Form visit(Ast.If node) {
    return statement(() -> Statements.conditional(node));
  }

  @Override
  public Form visit(Ast.While node) {
    return statement(() -> Statements.loop(node));
  }

  @Override
  public Form visit(Ast.For node) {
    return statement(
        () -> Statements.loop("for", node.flavor(), Statements.clauses(node), node.body()));
  }

  @Override
  public Form visit(Ast.ForEach node) {
    return statement(
        () -> Statements.loop("for", node.flavor(), Statements.range(node), node.body()));
  }

  @Override
  public Form visit(Ast.Loop node) {
    return statement(() -> Statements.loop(node));
  }

  @Override
  public Form visit(Ast.Switch node) {
    return statement(() -> Statements.choice(node));
  }

  @Override
  public Form visit(Ast.Return node) {
    return statement(() -> "return" + Statements.value(node.value()));
  }

  @Override
  public Form visit(Ast.Break node) {
    return statement(() -> "break");
  }

  @Override
  public Form visit(Ast.Continue node) {
    return statement(() -> "continue");
  }

  @Override
  public Form visit(Ast.Throw node) {
    return statement(() -> "throw" + Statements.value(node.value()));
  }

  @Override
  public Form visit(Ast.Try node) {
    return statement(() -> Statements.attempt(node));
  }

  @Override
  public Form visit(Ast.Assert node) {
    return statement(() -> Statements.claim(node));
  }

  @Override
  public Form visit(Ast.Tagged node) {
    return statement(() -> Statements.tagged(node));
  }

  @Override
  public Form visit(Ast.At node) {
    return statement(() -> Events.at(node));
  }

  @Override
  public Form visit(Ast.Whenever node) {
    return statement(() -> Events.whenever(node));
  }

  @Override
  public Form visit(Ast.WaitUntil node) {
    return statement(() -> "waituntil " + Events.condition(node.condition()));
  }

  @Override
  public Form visit(Ast.Watch node) {
    return tight(() -> Expressions.watch(node));
  }

  @Override
  public Form visit(Ast.Emit node) {
    Ast duration = node.duration();
    return duration == null
        ? tight(() -> Expressions.emission(node))
        : statement(() -> Events.lasting(node, duration));
  }

  @Override
  public Form visit(Ast.Every node) {
    return statement(() -> Statements.every(node));
  }

  @Override
  public Form visit(Ast.Timeout node) {
    return statement(() -> Statements.timeout(node));
  }

  @Override
  public Form visit(Ast.StopIf node) {
    return statement(() -> Statements.conditional("stopif", node.condition(), node.body()));
  }

  @Override
  public Form visit(Ast.FreezeIf node) {
    return statement(() -> Statements.conditional("freezeif", node.condition(), node.body()));
  }
}
