package org.urbi.kernel.tier;

import java.lang.classfile.Label;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Conditionals;
import org.urbi.kernel.node.ForEach;
import org.urbi.kernel.node.Jumps;
import org.urbi.kernel.node.Loops;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Sequences;

/** Emits sequences, conditionals and jumps. */
final class EmitStatements {
  private final Emitter to;

  EmitStatements(Emitter to) {
    this.to = to;
  }

  /** The value of a statement; null for nodes of another kind. */
  @Nullable Value value(Node node) {
    if (node instanceof Sequences.Chain chain) {
      return chain(chain);
    }
    if (node instanceof Sequences.Located located) {
      return to.lastStatement(located.code());
    }
    if (node instanceof Conditionals.If choice) {
      return choice(choice);
    }
    if (node instanceof Conditionals.Logical logical) {
      return logical(logical);
    }
    if (node instanceof Loops.Sequential loop) {
      return to.loops().value(loop);
    }
    if (node instanceof ForEach loop && EmitLoops.canCount(loop)) {
      return to.loops().value(loop);
    }
    if (node instanceof Jumps.Return jump && jump.isPlain()) {
      Value value = jump.value() == null ? to.voidValue() : to.operand(jump.value());
      to.loops().leaveFunction(value);
      return unreachable();
    }
    if (node instanceof Jumps.OfLoop jump && jump.isPlain() && to.loops().isInLoop()) {
      to.loops().leave(jump.isBreak());
      return unreachable();
    }
    return null;
  }

  /** Emits a statement whose value nobody uses; false, and nothing is emitted, for other kinds. */
  boolean effect(Node node) {
    if (node instanceof Sequences.Chain chain) {
      begin(chain);
      to.statement(chain.statements()[chain.statements().length - 1]);
    } else if (node instanceof Sequences.Located located) {
      to.statement(located.code());
    } else if (node instanceof Conditionals.If choice) {
      effect(choice);
    } else {
      return node instanceof Sequences.Noop;
    }
    return true;
  }

  private void effect(Conditionals.If choice) {
    Label otherwise = to.code.newLabel();
    to.located(choice, () -> to.condition(choice.condition(), otherwise));
    to.statement(choice.thenClause());
    Node elseClause = choice.elseClause();
    if (elseClause == null) {
      to.code.labelBinding(otherwise);
      return;
    }
    Label over = to.code.newLabel();
    to.code.goto_(over);
    to.code.labelBinding(otherwise);
    to.statement(elseClause);
    to.code.labelBinding(over);
  }

  /** What stands after a jump is never executed, but the Java machine verifies it. */
  private Value unreachable() {
    return to.voidValue();
  }

  private Value chain(Sequences.Chain chain) {
    begin(chain);
    return to.lastStatement(chain.statements()[chain.statements().length - 1]);
  }

  /** All statements but the last one. */
  private void begin(Sequences.Chain chain) {
    Node[] statements = chain.statements();
    for (int i = 0; i < statements.length - 1; i++) {
      to.statement(statements[i]);
      if (chain.yieldsAfter(i)) {
        to.loops().yieldToOthers();
      }
    }
  }

  private Value choice(Conditionals.If choice) {
    Label otherwise = to.code.newLabel();
    Label over = to.code.newLabel();
    Value result = to.newPair();
    to.located(choice, () -> to.condition(choice.condition(), otherwise));
    to.copy(to.lastStatement(choice.thenClause()), result);
    to.code.goto_(over);
    to.code.labelBinding(otherwise);
    Node elseClause = choice.elseClause();
    if (elseClause == null) {
      to.loadVoid();
      to.code.astore(result.object());
    } else {
      to.copy(to.lastStatement(elseClause), result);
    }
    to.code.labelBinding(over);
    return result;
  }

  private Value logical(Conditionals.Logical logical) {
    Label decided = to.code.newLabel();
    Value result = to.newPair();
    to.copy(to.operand(logical.left()), result);
    if (logical.isAnd()) {
      to.truth(result, decided);
    } else {
      Label on = to.code.newLabel();
      to.truth(result, on);
      to.code.goto_(decided);
      to.code.labelBinding(on);
    }
    to.copy(to.operand(logical.right()), result);
    to.code.labelBinding(decided);
    return result;
  }

  void condition(Conditionals.Logical logical, Label otherwise) {
    if (logical.isAnd()) {
      to.condition(logical.left(), otherwise);
      to.condition(logical.right(), otherwise);
      return;
    }
    Label right = to.code.newLabel();
    Label holds = to.code.newLabel();
    to.condition(logical.left(), right);
    to.code.goto_(holds);
    to.code.labelBinding(right);
    to.condition(logical.right(), otherwise);
    to.code.labelBinding(holds);
  }
}
