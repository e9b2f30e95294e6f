package org.urbi.kernel.compile;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.Emit;
import org.urbi.kernel.event.WatchExpression;
import org.urbi.kernel.node.Conditionals;
import org.urbi.kernel.node.Jumps;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Properties;
import org.urbi.kernel.node.Sequences;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.AstVisitor;

/** Compiles each kind of syntax tree node. */
final class TranslationVisitor implements AstVisitor<Node> {
  private static final Node[] NONE = {};

  private final Compilation compilation;
  private final LexicalScope block;
  private final HandledJumps seen;

  /**
   * @param block the scope around
   * @param seen which jumps the surrounding statements check for, so that {@code return} and {@code
   *     break} need not be thrown as exceptions
   */
  TranslationVisitor(Compilation compilation, LexicalScope block, HandledJumps seen) {
    this.compilation = compilation;
    this.block = block;
    this.seen = seen;
  }

  private Node operand(Ast ast) {
    return compilation.operand(ast, block);
  }

  private @Nullable Node optional(@Nullable Ast ast) {
    return compilation.optional(ast, block);
  }

  private Node[] all(List<Ast> asts) {
    return compilation.all(asts, block);
  }

  @Override
  public Node visit(Ast.FloatLiteral literal) {
    return new Literals.Number(literal.span(), literal.value());
  }

  @Override
  public Node visit(Ast.StringLiteral literal) {
    return new Literals.Text(literal.span(), literal.value());
  }

  @Override
  public Node visit(Ast.ListLiteral literal) {
    return new Literals.Sequence(literal.span(), all(literal.elements()), false);
  }

  @Override
  public Node visit(Ast.TupleLiteral literal) {
    return new Literals.Sequence(literal.span(), all(literal.elements()), true);
  }

  @Override
  public Node visit(Ast.DictionaryLiteral literal) {
    return new Literals.Dictionary(
        literal.span(),
        all(literal.entries().stream().map(Ast.Entry::key).toList()),
        all(literal.entries().stream().map(Ast.Entry::value).toList()));
  }

  @Override
  public Node visit(Ast.This it) {
    return new Literals.This(it.span());
  }

  @Override
  public Node visit(Ast.CallMessage call) {
    return compilation.expressions.callMessage(call, block);
  }

  @Override
  public Node visit(Ast.Message message) {
    return compilation.expressions.message(message, block);
  }

  @Override
  public Node visit(Ast.And and) {
    return new Conditionals.Logical(and.span(), true, operand(and.left()), operand(and.right()));
  }

  @Override
  public Node visit(Ast.Or or) {
    return new Conditionals.Logical(or.span(), false, operand(or.left()), operand(or.right()));
  }

  @Override
  public Node visit(Ast.SlotAccess access) {
    return compilation.expressions.slotAccess(access, block);
  }

  @Override
  public Node visit(Ast.Property property) {
    return new Properties.Read(
        property.span(),
        compilation.receivers.target(property.target(), property.slot(), property.span(), block),
        compilation.interpreter().world().symbol(property.slot()),
        property.name());
  }

  @Override
  public Node visit(Ast.Declaration declaration) {
    return compilation.definitions.declaration(declaration, block);
  }

  @Override
  public Node visit(Ast.Assignment assignment) {
    return compilation.assignments.assignment(assignment, block);
  }

  @Override
  public Node visit(Ast.OperatorAssignment assignment) {
    return compilation.assignments.inPlace(assignment, block);
  }

  @Override
  public Node visit(Ast.Postfix postfix) {
    return compilation.assignments.postfix(postfix, block);
  }

  @Override
  public Node visit(Ast.Trajectory trajectory) {
    return compilation.assignments.trajectory(trajectory, block);
  }

  @Override
  public Node visit(Ast.Function function) {
    return compilation.functions.compile(function, block);
  }

  @Override
  public Node visit(Ast.FunctionDefinition definition) {
    return compilation.definitions.function(definition, block);
  }

  @Override
  public Node visit(Ast.Accessor accessor) {
    return compilation.definitions.accessor(accessor, block);
  }

  @Override
  public Node visit(Ast.ClassDefinition definition) {
    return compilation.definitions.classDefinition(definition, block);
  }

  @Override
  public Node visit(Ast.PackageDefinition definition) {
    return compilation.definitions.packageDefinition(definition, block);
  }

  @Override
  public Node visit(Ast.Import definition) {
    return compilation.receivers.importFrom(definition, block);
  }

  @Override
  public Node visit(Ast.EnumDefinition definition) {
    return compilation.definitions.enumDefinition(definition, block);
  }

  @Override
  public Node visit(Ast.Sequence sequence) {
    return compilation.statements.sequence(sequence, block, seen);
  }

  @Override
  public Node visit(Ast.Scope scope) {
    return compilation.statements.scope(scope, block, seen);
  }

  @Override
  public Node visit(Ast.Do scope) {
    return compilation.expressions.doScope(scope, block);
  }

  @Override
  public Node visit(Ast.Noop noop) {
    return new Sequences.Noop(noop.span());
  }

  @Override
  public Node visit(Ast.If statement) {
    return compilation.statements.ifElse(statement, block, seen);
  }

  @Override
  public Node visit(Ast.While loop) {
    return compilation.statements.loop(
        loop.span(), loop.flavor(), null, loop.condition(), null, loop.body(), block, seen);
  }

  @Override
  public Node visit(Ast.For loop) {
    return compilation.statements.loop(
        loop.span(),
        loop.flavor(),
        loop.init(),
        loop.condition(),
        loop.step(),
        loop.body(),
        block,
        seen);
  }

  @Override
  public Node visit(Ast.ForEach loop) {
    return compilation.statements.forEach(loop, block, seen);
  }

  @Override
  public Node visit(Ast.Loop loop) {
    return compilation.statements.loop(
        loop.span(), loop.flavor(), null, null, null, loop.body(), block, seen);
  }

  @Override
  public Node visit(Ast.Switch statement) {
    return compilation.statements.switchCase(statement, block, seen);
  }

  @Override
  public Node visit(Ast.Return jump) {
    block.unit().addReturn();
    return new Jumps.Return(
        jump.span(), optional(jump.value()), block.unit().closure, seen == HandledJumps.ALL);
  }

  @Override
  public Node visit(Ast.Break jump) {
    return new Jumps.OfLoop(jump.span(), true, seen != HandledJumps.NOTHING);
  }

  @Override
  public Node visit(Ast.Continue jump) {
    return new Jumps.OfLoop(jump.span(), false, seen != HandledJumps.NOTHING);
  }

  @Override
  public Node visit(Ast.Throw jump) {
    return new Jumps.Throw(jump.span(), optional(jump.value()));
  }

  @Override
  public Node visit(Ast.Try statement) {
    return compilation.statements.tryCatch(statement, block, seen);
  }

  @Override
  public Node visit(Ast.Assert statement) {
    return compilation.statements.assertion(statement, block);
  }

  @Override
  public Node visit(Ast.Tagged tagged) {
    return compilation.handlers.tagged(tagged, block, seen);
  }

  @Override
  public Node visit(Ast.At at) {
    return compilation.handlers.at(at, block);
  }

  @Override
  public Node visit(Ast.Whenever whenever) {
    return compilation.handlers.whenever(whenever, block);
  }

  @Override
  public Node visit(Ast.WaitUntil wait) {
    return compilation.handlers.waitUntil(wait, block);
  }

  @Override
  public Node visit(Ast.Watch watch) {
    return new WatchExpression(
        watch.span(), compilation.operand(watch.expression(), block.job(compilation.newRegion())));
  }

  @Override
  public Node visit(Ast.Emit emit) {
    return new Emit(
        emit.span(),
        operand(emit.event()),
        emit.arguments() == null ? NONE : all(emit.arguments()),
        optional(emit.duration()));
  }

  @Override
  public Node visit(Ast.Every every) {
    return compilation.handlers.every(every, block, seen);
  }

  @Override
  public Node visit(Ast.Timeout timeout) {
    return compilation.handlers.timeout(timeout, block, seen);
  }

  @Override
  public Node visit(Ast.StopIf watched) {
    return compilation.handlers.stopIf(watched, block, seen);
  }

  @Override
  public Node visit(Ast.FreezeIf watched) {
    return compilation.handlers.freezeIf(watched, block, seen);
  }
}
