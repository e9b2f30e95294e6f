package org.urbi.kernel.tier;

import java.lang.classfile.Label;
import java.lang.constant.ConstantDescs;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.Conditionals;
import org.urbi.kernel.node.ForEach;
import org.urbi.kernel.node.Jumps;
import org.urbi.kernel.node.Loops;
import org.urbi.kernel.node.Matching;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Pattern;
import org.urbi.kernel.node.ScopeEnd;
import org.urbi.kernel.node.Sequences;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.node.Try;

/** Emits sequences, conditionals and jumps. */
final class EmitStatements {
  private final Emitter to;

  EmitStatements(Emitter to) {
    this.to = to;
  }

  /**
   * The value of a statement; null for nodes of another kind, and loops that are compiled by
   * themselves.
   */
  @Nullable Value value(Node node) {
    if (node instanceof Sequences.Chain chain) {
      return chain(chain);
    }
    if (node instanceof Sequences.Located located) {
      return to.lastStatement(located.code());
    }
    if (node instanceof ScopeEnd.Scope scope) {
      return to.scopes().value(scope);
    }
    if (node instanceof Conditionals.If choice) {
      return choice(choice);
    }
    if (node instanceof Conditionals.Logical logical) {
      return logical(logical);
    }
    if (node instanceof Matching.Switch choice) {
      return choice(choice);
    }
    if (node instanceof Loops.Sequential loop && !loop.turns().isCompiled()) {
      return to.loops().value(loop);
    }
    if (node instanceof ForEach loop && EmitLoops.canCount(loop) && !loop.turns().isCompiled()) {
      return to.loops().value(loop);
    }
    if (node instanceof Try attempt && Survey.canEmit(attempt) && !to.isPlaced()) {
      return to.tries().value(attempt);
    }
    if (node instanceof Jumps.Throw jump) {
      return to.tries().value(jump);
    }
    if (node instanceof Jumps.Return jump && jump.isPlain()) {
      Value value = jump.value() == null ? to.voidValue() : to.operand(jump.value());
      to.loops().leaveFunction(value);
      return to.unreachable();
    }
    if (node instanceof Jumps.OfLoop jump && jump.isPlain() && to.loops().isInLoop()) {
      to.loops().leave(jump.isBreak());
      return to.unreachable();
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
    } else if (node instanceof ScopeEnd.Scope scope) {
      to.scopes().effect(scope);
    } else if (node instanceof Conditionals.If choice) {
      effect(choice);
    } else if (node instanceof Slots.Assign assignment) {
      to.slots().effect(assignment);
    } else if (node instanceof CompoundAssignment assignment
        && assignment.access() instanceof CompoundAssignment.Slot slot) {
      return to.arithmetic().formulas().count(assignment, slot);
    } else {
      return node instanceof Sequences.Noop;
    }
    return true;
  }

  /** Emits what a function does last, and leaves it; false, and nothing is emitted, for others. */
  boolean last(Node node) {
    if (node instanceof Sequences.Chain chain) {
      begin(chain);
      to.last(chain.statements()[chain.statements().length - 1]);
    } else if (node instanceof Sequences.Located located) {
      to.last(located.code());
    } else if (node instanceof ScopeEnd.Scope scope) {
      to.scopes().last(scope);
    } else if (node instanceof Conditionals.If choice) {
      Label otherwise = to.code.newLabel();
      to.located(choice, () -> to.condition(choice.condition(), otherwise));
      to.last(choice.thenClause());
      to.code.labelBinding(otherwise);
      Node elseClause = choice.elseClause();
      if (elseClause == null) {
        to.answer(to.voidValue());
      } else {
        to.last(elseClause);
      }
    } else {
      return false;
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
        to.loops().yieldToOthers(statements[i]);
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

  private Value choice(Matching.Switch choice) {
    Value given = to.operand(choice.value());
    if (given.hasObject()) {
      to.located(choice, () -> to.notVoid(given));
    }
    to.load(given);
    Value value = to.storedObject();
    Value result = to.newPair();
    Label over = to.code.newLabel();
    for (Matching.Case each : choice.cases()) {
      Label next = to.code.newLabel();
      matches(each.pattern(), value, next);
      if (each.guard() != null) {
        to.condition(each.guard(), next);
      }
      to.copy(to.lastStatement(each.body()), result);
      to.code.goto_(over);
      to.code.labelBinding(next);
    }
    if (choice.defaultCase() == null) {
      to.loadVoid();
      to.code.astore(result.object());
    } else {
      to.copy(to.lastStatement(choice.defaultCase()), result);
    }
    to.code.labelBinding(over);
    return result;
  }

  /** Jumps unless the value matches. */
  private void matches(Pattern pattern, Value value, Label otherwise) {
    int matched = to.newFlag();
    to.beside(
        Survey.of(pattern),
        () -> {
          to.code.aload(value.object());
          to.frame();
          to.constant(pattern, Names.PATTERN);
          to.place();
          to.help(
              "matches",
              ConstantDescs.CD_boolean,
              Names.OBJECT,
              Names.FRAME,
              Names.PATTERN,
              Names.NODE);
          to.code.istore(matched).aload(value.object());
        });
    to.code.iload(matched).ifeq(otherwise);
  }

  private Value logical(Conditionals.Logical logical) {
    Label decided = to.code.newLabel();
    Value result = to.newPair();
    to.copy(to.operand(logical.left()), result);
    if (logical.isAnd()) {
      to.located(logical.left(), () -> truth(result, decided));
    } else {
      Label on = to.code.newLabel();
      to.located(logical.left(), () -> truth(result, on));
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

  /** Jumps unless the value is true. */
  void truth(Value value, Label otherwise) {
    Label over = to.code.newLabel();
    if (value.hasNumber()) {
      Label object = to.code.newLabel();
      if (value.hasObject()) {
        to.code.aload(value.object()).ifnonnull(object);
      }
      to.code.dload(value.number()).dconst_0().dcmpl().ifeq(otherwise);
      to.code.goto_(over);
      to.code.labelBinding(object);
    }
    if (value.hasObject()) {
      to.code.aload(value.object());
      to.loadBoolean(true);
      to.code.if_acmpeq(over).aload(value.object());
      to.loadBoolean(false);
      to.code.if_acmpeq(otherwise).aload(value.object());
      to.frame();
      to.place();
      to.help("truth", ConstantDescs.CD_boolean, Names.OBJECT, Names.FRAME, Names.NODE);
      to.code.ifeq(otherwise);
    }
    to.code.labelBinding(over);
  }
}
