package org.urbi.lang.print;

import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.AstVisitor;

/** How tight a node binds. */
enum Binding {
  /** Needs braces where a value is expected. */
  STATEMENT,
  /** Needs parentheses where a message is sent to it. */
  LOOSE,
  TIGHT;

  private static final Kinds KINDS = new Kinds();

  static Binding of(Ast tree) {
    return tree.accept(KINDS);
  }

  /** What each kind of node is. */
  private static final class Kinds implements AstVisitor<Binding> {
    @Override
    public Binding visit(Ast.FloatLiteral node) {
      return node.value() >= 0 ? TIGHT : LOOSE;
    }

    @Override
    public Binding visit(Ast.StringLiteral node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.ListLiteral node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.TupleLiteral node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.DictionaryLiteral node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.This node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.CallMessage node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.Message node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.And node) {
      return LOOSE;
    }

    @Override
    public Binding visit(Ast.Or node) {
      return LOOSE;
    }

    @Override
    public Binding visit(Ast.SlotAccess node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.Property node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.Declaration node) {
      return LOOSE;
    }

    @Override
    public Binding visit(Ast.Assignment node) {
      return LOOSE;
    }

    @Override
    public Binding visit(Ast.OperatorAssignment node) {
      return LOOSE;
    }

    @Override
    public Binding visit(Ast.Postfix node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.Trajectory node) {
      return LOOSE;
    }

    @Override
    public Binding visit(Ast.Function node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.FunctionDefinition node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.Accessor node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.ClassDefinition node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.PackageDefinition node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Import node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.EnumDefinition node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Sequence node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Scope node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.Do node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.Noop node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.If node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.While node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.For node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.ForEach node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Loop node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Switch node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Return node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Break node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Continue node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Throw node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Try node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Assert node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Tagged node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.At node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Whenever node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.WaitUntil node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Watch node) {
      return TIGHT;
    }

    @Override
    public Binding visit(Ast.Emit node) {
      return node.duration() == null ? TIGHT : STATEMENT;
    }

    @Override
    public Binding visit(Ast.Every node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.Timeout node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.StopIf node) {
      return STATEMENT;
    }

    @Override
    public Binding visit(Ast.FreezeIf node) {
      return STATEMENT;
    }
  }
}
