package org.urbi.lang.ast;

/**
 * A method for each kind of node: a new kind of node does not compile until every visitor handles
 * it.
 *
 * <p>It is used instead of a {@code switch} over the sealed tree, because the JDK links such a
 * switch anew in each process when it first runs, which takes longer than all the rest of starting
 * a kernel.
 *
 * @param <R> the result for a node
 */
public interface AstVisitor<R> {
  R visit(Ast.FloatLiteral node);

  R visit(Ast.StringLiteral node);

  R visit(Ast.ListLiteral node);

  R visit(Ast.TupleLiteral node);

  R visit(Ast.DictionaryLiteral node);

  R visit(Ast.This node);

  R visit(Ast.CallMessage node);

  R visit(Ast.Message node);

  R visit(Ast.And node);

  R visit(Ast.Or node);

  R visit(Ast.SlotAccess node);

  R visit(Ast.Property node);

  R visit(Ast.Declaration node);

  R visit(Ast.Assignment node);

  R visit(Ast.OperatorAssignment node);

  R visit(Ast.Postfix node);

  R visit(Ast.Trajectory node);

  R visit(Ast.Function node);

  R visit(Ast.FunctionDefinition node);

  R visit(Ast.Accessor node);

  R visit(Ast.ClassDefinition node);

  R visit(Ast.PackageDefinition node);

  R visit(Ast.Import node);

  R visit(Ast.EnumDefinition node);

  R visit(Ast.Sequence node);

  R visit(Ast.Scope node);

  R visit(Ast.Do node);

  R visit(Ast.Noop node);

  R visit(Ast.If node);

  R visit(Ast.While node);

  R visit(Ast.For node);

  R visit(Ast.ForEach node);

  R visit(Ast.Loop node);

  R visit(Ast.Switch node);

  R visit(Ast.Return node);

  R visit(Ast.Break node);

  R visit(Ast.Continue node);

  R visit(Ast.Throw node);

  R visit(Ast.Try node);

  R visit(Ast.Assert node);

  R visit(Ast.Tagged node);

  R visit(Ast.At node);

  R visit(Ast.Whenever node);

  R visit(Ast.WaitUntil node);

  R visit(Ast.Watch node);

  R visit(Ast.Emit node);

  R visit(Ast.Every node);

  R visit(Ast.Timeout node);

  R visit(Ast.StopIf node);

  R visit(Ast.FreezeIf node);
}
