package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_boolean;

import java.lang.classfile.Label;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Jumps;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Pattern;
import org.urbi.kernel.node.Try;

/**
 * Emits {@code try} and {@code throw}. The variables are in slots of the Java method, which an
 * exception leaves as they are, so that what handles it finds them.
 */
final class EmitTry {
  private final Emitter to;

  /** How many pieces of code are being emitted whose exceptions are handled. */
  private int handling;

  /** The clauses whose body is being emitted, innermost first. */
  private final Deque<Clause> open = new ArrayDeque<>();

  /**
   * A clause that handles an exception.
   *
   * @param outer the slot of the exception that is handled around it
   * @param loops how many loops are around it
   */
  private record Clause(int outer, int loops) {}

  EmitTry(Emitter to) {
    this.to = to;
  }

  /** Whether there are exceptions that do not leave the function. */
  boolean isHandling() {
    return handling > 0;
  }

  Value value(Try node) {
    Value result = to.newPair();
    to.loadVoid();
    to.code.astore(result.object());
    Node last = node.finallyClause();
    if (last == null) {
      catching(node, result);
    } else {
      finishing(node, last, result);
    }
    return result;
  }

  /** Emits {@code throw}: what handles the exception may be in the same code, a jump away. */
  Value value(Jumps.Throw node) {
    Node value = node.value();
    if (value == null) {
      to.frame();
      to.constant(node, Names.THROW);
      to.help("thrownAgain", Names.EXCEPTION, Names.FRAME, Names.THROW);
    } else {
      to.load(to.operand(value));
      to.frame();
      to.constant(node, Names.THROW);
      to.help("thrown", Names.EXCEPTION, Names.OBJECT, Names.FRAME, Names.THROW);
    }
    to.code.athrow();
    return to.unreachable();
  }

  private void finishing(Try node, Node last, Value result) {
    int thrown = to.newObject();
    to.code.aconst_null().astore(thrown);
    handling++;
    Label start = to.beginRange();
    catching(node, result);
    Label end = to.code.newBoundLabel();
    handling--;
    Label finish = to.code.newLabel();
    to.code.goto_(finish);
    Label handler = to.code.newBoundLabel();
    to.code.astore(thrown);
    to.code.exceptionCatchAll(start, end, handler);
    to.afterOthers();
    to.code.labelBinding(finish);
    to.statement(last);
    Label over = to.code.newLabel();
    to.code.aload(thrown).ifnull(over).aload(thrown).athrow();
    to.code.labelBinding(over);
  }

  private void catching(Try node, Value result) {
    Label over = to.code.newLabel();
    handling++;
    Label start = to.beginRange();
    to.copy(to.lastStatement(node.body()), result);
    Label end = to.code.newBoundLabel();
    handling--;
    if (node.elseClause() != null) {
      to.copy(to.lastStatement(node.elseClause()), result);
    }
    to.code.goto_(over);
    Label handler = to.code.newBoundLabel();
    int caught = to.newObject();
    to.frame();
    to.constant(node, Names.TRY);
    to.help("caught", Names.EXCEPTION, Names.THROWABLE, Names.FRAME, Names.TRY);
    to.code.astore(caught);
    to.code.exceptionCatchAll(start, end, handler);
    to.afterOthers();
    for (Try.Clause clause : node.clauses()) {
      Label next = to.code.newLabel();
      clause(clause, caught, result, next);
      to.code.goto_(over);
      to.code.labelBinding(next);
    }
    to.code.aload(caught).athrow();
    to.code.labelBinding(over);
  }

  /** Emits a clause; jumps if it does not handle the exception. */
  private void clause(Try.Clause clause, int caught, Value result, Label next) {
    Pattern pattern = clause.pattern();
    if (pattern != null) {
      matches(clause, pattern, caught, next);
    }
    if (clause.guard() != null) {
      to.condition(clause.guard(), next);
    }
    int outer = to.newObject();
    swap(caught);
    to.code.astore(outer);
    open.push(new Clause(outer, to.loops().around()));
    handling++;
    Label start = to.beginRange();
    to.copy(to.lastStatement(clause.body()), result);
    Label end = to.code.newBoundLabel();
    handling--;
    open.pop();
    Label over = to.code.newLabel();
    restore(outer);
    to.code.goto_(over);
    Label handler = to.code.newBoundLabel();
    restore(outer);
    to.code.athrow();
    to.code.exceptionCatchAll(start, end, handler);
    to.code.labelBinding(over);
  }

  private void matches(Try.Clause clause, Pattern pattern, int caught, Label otherwise) {
    int matched = to.newFlag();
    to.beside(
        Survey.of(pattern),
        () -> {
          to.code.aload(caught);
          to.frame();
          to.constant(clause, Names.CLAUSE);
          to.help("catches", CD_boolean, Names.EXCEPTION, Names.FRAME, Names.CLAUSE);
          to.code.istore(matched);
          to.loadVoid();
        });
    to.code.iload(matched).ifeq(otherwise);
  }

  /** Makes an exception the one that is being handled; leaves the other one on the stack. */
  private void swap(int exception) {
    to.code.aload(exception);
    to.frame();
    to.help("handling", Names.EXCEPTION, Names.EXCEPTION, Names.FRAME);
  }

  private void restore(int outer) {
    swap(outer);
    to.code.pop();
  }

  /** Emits the end of the clauses that are inside of so many loops: they are about to be left. */
  void leave(int loops) {
    @Nullable Clause last = null;
    for (Clause clause : open) {
      if (clause.loops() >= loops) {
        last = clause;
      }
    }
    if (last != null) {
      restore(last.outer());
    }
  }
}
