package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_boolean;
import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_int;

import java.lang.classfile.Label;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.NumericOperator;
import org.urbi.kernel.object.Symbol;

/**
 * Emits operators of numbers, guarded as in the nodes: both operands are plain numbers, and nobody
 * has redefined the operator. Otherwise the node answers.
 */
final class EmitArithmetic {
  private static final ClassDesc MATH = Math.class.describeConstable().orElseThrow();
  private static final MethodTypeDesc POWER = MethodTypeDesc.of(CD_double, CD_double, CD_double);

  private final Emitter to;
  private final EmitFormula formulas;

  EmitArithmetic(Emitter to, EmitSlots slots) {
    this.to = to;
    this.formulas = new EmitFormula(to, this, slots);
  }

  // ------------------------------------------------------------------ a + b

  Value value(NumericOperator operator) {
    boolean comparison = operator.isComparison();
    if (!comparison && formulas.fits(operator)) {
      return formulas.value(operator);
    }
    Value result = to.newPair();
    operate(
        operator,
        result,
        (left, right) -> {
          if (comparison) {
            Label otherwise = to.code.newLabel();
            Label stored = to.code.newLabel();
            jumpUnless(operator, left, right, otherwise);
            to.loadBoolean(true);
            to.code.goto_(stored);
            to.code.labelBinding(otherwise);
            to.loadBoolean(false);
            to.code.labelBinding(stored);
            to.code.astore(result.object());
          } else {
            compute(operator, left, right, result);
          }
        });
    return comparison ? Value.ofObject(result.object()) : result;
  }

  /** Emits a comparison as a condition, without an object. */
  void condition(NumericOperator operator, Label otherwise) {
    if (formulas.fits(operator)) {
      formulas.condition(operator, otherwise);
      return;
    }
    Label over = to.code.newLabel();
    Value result = to.newPair();
    operate(
        operator,
        result,
        (left, right) -> {
          jumpUnless(operator, left, right, otherwise);
          to.code.goto_(over);
        });
    if (operator.isEquality() || !to.loops().isQuick()) {
      to.statements().truth(Value.ofObject(result.object()), otherwise);
    }
    to.code.labelBinding(over);
  }

  /** What is done with two plain numbers. */
  private interface Fast {
    void emit(int left, int right);
  }

  /** Leaves what the node answers in the object of the result, if the operands are others. */
  private void operate(NumericOperator operator, Value result, Fast fast) {
    boolean equality = operator.isEquality();
    Label neither = equality ? to.code.newLabel() : to.loops().unexpected(operator);
    Label mixed = equality ? to.code.newLabel() : to.loops().unexpected(operator);
    Label ready = to.code.newLabel();
    Label over = to.code.newLabel();
    int equates = equality ? to.newFlag() : -1;
    Value left = to.kept(to.operand(operator.left()), operator.right());
    if (equates >= 0) {
      to.code.iconst_0().istore(equates);
    }
    int a = to.number(left, neither);
    intact(operator.name(), operator, Names.OPERATOR, operator.isIntact(), neither);
    if (equates >= 0) {
      to.code.goto_(ready);
      to.code.labelBinding(neither);
      to.load(left);
      to.constant(operator, Names.OPERATOR);
      to.help("equatesAsBefore", CD_boolean, Names.OBJECT, Names.OPERATOR);
      to.code.dup().istore(equates).ifne(ready);
      to.load(left);
      to.frame();
      to.constant(operator, Names.OPERATOR);
      to.place();
      to.help("equates", CD_boolean, Names.OBJECT, Names.FRAME, Names.OPERATOR, Names.NODE);
      to.code.dup().istore(equates);
      neither = to.code.newLabel();
      to.code.ifeq(neither);
      to.code.labelBinding(ready);
    }
    Value right = to.operand(operator.right());
    if (equates >= 0) {
      equal(operator, equates, left, right, result, over);
    }
    int b = to.number(right, mixed);
    if (operator.divides()) {
      to.code.dload(b).dconst_0().dcmpl().ifeq(mixed);
    }
    fast.emit(a, b);
    if (!equality && to.loops().isQuick()) {
      return;
    }
    to.code.goto_(over);
    to.code.labelBinding(neither);
    to.releasing(() -> {
      Value answer =
          to.beside(
              operator.right(),
              () -> {
                to.load(left);
                to.frame();
                to.constant(operator, Names.OPERATOR);
                to.help("operate", Names.OBJECT, Names.OBJECT, Names.FRAME, Names.OPERATOR);
              });
      to.code.aload(answer.object()).astore(result.object()).goto_(over);
    });
    if (right.hasObject() || operator.divides() || to.isDoubtful()) {
      to.code.labelBinding(mixed);
      to.load(left);
      to.load(right);
      to.frame();
      to.constant(operator, Names.OPERATOR);
      to.help("operate", Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.OPERATOR);
      to.code.astore(result.object());
      to.afterOthers();
    }
    to.code.labelBinding(over);
  }

  /** Compares objects by an operator of the library, which has been found. */
  private void equal(
      NumericOperator operator, int equates, Value left, Value right, Value result, Label over) {
    Label numbers = to.code.newLabel();
    to.code.iload(equates).ifeq(numbers);
    to.located(operator.message(), () -> to.notVoid(right));
    to.load(left);
    to.load(right);
    to.constant(operator, Names.OPERATOR);
    to.constant(to.values, Names.VALUES);
    to.help("isSame", Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.OPERATOR, Names.VALUES);
    to.code.astore(result.object()).goto_(over);
    to.code.labelBinding(numbers);
  }

  private void compute(NumericOperator operator, int left, int right, Value result) {
    to.code.dload(left).dload(right);
    compute(operator);
    setNumber(result);
  }

  /** Computes with the two doubles on the stack. */
  void compute(NumericOperator operator) {
    switch (operator.name().name()) {
      case "+" -> to.code.dadd();
      case "-" -> to.code.dsub();
      case "*" -> to.code.dmul();
      case "/" -> to.code.ddiv();
      case "%" -> to.code.drem();
      case "**" -> to.code.invokestatic(MATH, "pow", POWER);
      default -> throw new IllegalArgumentException(operator.name().name());
    }
  }

  /** The double on the stack, of which there is no object yet. */
  void setNumber(Value pair) {
    to.code.dstore(pair.number()).aconst_null().astore(pair.object());
  }

  private void jumpUnless(NumericOperator operator, int left, int right, Label otherwise) {
    to.code.dload(left).dload(right);
    jumpUnless(operator, otherwise);
  }

  /**
   * Compares the two doubles on the stack. A comparison with what is not a number does not hold,
   * but for "different".
   */
  void jumpUnless(NumericOperator operator, Label otherwise) {
    switch (operator.name().name()) {
      case "<" -> to.code.dcmpg().ifge(otherwise);
      case "<=" -> to.code.dcmpg().ifgt(otherwise);
      case ">" -> to.code.dcmpl().ifle(otherwise);
      case ">=" -> to.code.dcmpl().iflt(otherwise);
      case "==" -> to.code.dcmpl().ifne(otherwise);
      case "!=" -> to.code.dcmpl().ifeq(otherwise);
      default -> throw new IllegalArgumentException(operator.name().name());
    }
  }

  /**
   * Jumps if somebody has redefined the operator. The epoch of its name tells at once; when that
   * has changed, which any slot of the name may be the reason of, the node looks.
   */
  void intact(Symbol name, Node node, ClassDesc type, boolean now, Label otherwise) {
    Label over = to.code.newLabel();
    if (now) {
      to.constant(name, Names.SYMBOL);
      to.code
          .invokevirtual(Names.SYMBOL, "epoch", MethodTypeDesc.of(CD_int))
          .loadConstant(name.epoch())
          .if_icmpeq(over);
    }
    to.constant(node, type);
    to.code
        .invokevirtual(type, "isIntact", MethodTypeDesc.of(ConstantDescs.CD_boolean))
        .ifeq(otherwise);
    to.code.labelBinding(over);
  }

  /** Emits formulas. */
  EmitFormula formulas() {
    return formulas;
  }

  // ------------------------------------------------------------------ a += b, a++

  Value value(CompoundAssignment assignment) {
    Value variable = to.variable(assignment.local());
    Node operand = assignment.operand();
    if (operand == null) {
      Value before = to.newPair();
      to.located(assignment, () -> count(assignment, variable, before));
      to.afterStore(variable);
      return before;
    }
    to.located(assignment, () -> combine(assignment, operand, variable));
    to.afterStore(variable);
    return variable;
  }

  /** Where it is done if something is not as expected, if there is anything to expect. */
  private Label unexpected(CompoundAssignment assignment) {
    return assignment.sign() == 0 ? to.code.newLabel() : to.loops().unexpected(assignment);
  }

  /** The new value of anything but a plain variable. */
  Value combined(CompoundAssignment assignment, Value before) {
    Label slow = unexpected(assignment);
    Label over = to.code.newLabel();
    Value result = to.newPair();
    Node operand = assignment.operand();
    Value by = operand == null ? null : to.operand(operand);
    if (by != null) {
      to.notVoid(by);
    }
    if (assignment.sign() != 0) {
      int a = to.number(before, slow);
      intact(assignment.operator(), assignment, Names.COUNTING, assignment.isIntact(), slow);
      if (by == null) {
        to.code.dload(a).loadConstant((double) assignment.sign()).dadd();
      } else {
        int b = to.number(by, slow);
        to.code.dload(a).dload(b);
        if (assignment.sign() > 0) {
          to.code.dadd();
        } else {
          to.code.dsub();
        }
      }
      setNumber(result);
      if (to.loops().isQuick()) {
        return result;
      }
      to.code.goto_(over);
    }
    to.code.labelBinding(slow);
    to.load(before);
    if (by == null) {
      to.frame();
      to.constant(assignment, Names.COUNTING);
      to.help("successor", Names.OBJECT, Names.OBJECT, Names.FRAME, Names.COUNTING);
    } else {
      to.load(by);
      to.frame();
      to.constant(assignment, Names.COUNTING);
      to.help("combined", Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.COUNTING);
    }
    changed(result);
    to.code.labelBinding(over);
    return result;
  }

  private void count(CompoundAssignment assignment, Value variable, Value before) {
    Label slow = unexpected(assignment);
    Label over = to.code.newLabel();
    if (assignment.sign() != 0) {
      int number = to.number(variable, slow);
      intact(assignment.operator(), assignment, Names.COUNTING, assignment.isIntact(), slow);
      to.code.dload(number).dstore(before.number());
      to.code.aload(variable.object()).astore(before.object());
      to.code.dload(number).loadConstant((double) assignment.sign()).dadd();
      setNumber(variable);
      if (to.loops().isQuick()) {
        return;
      }
      to.code.goto_(over);
    }
    to.code.labelBinding(slow);
    to.load(variable);
    to.code.astore(before.object());
    to.code.aload(before.object());
    to.frame();
    to.constant(assignment, Names.COUNTING);
    to.help("successor", Names.OBJECT, Names.OBJECT, Names.FRAME, Names.COUNTING);
    changed(variable);
    to.code.labelBinding(over);
  }

  private void combine(CompoundAssignment assignment, Node operand, Value variable) {
    Label slow = unexpected(assignment);
    Label over = to.code.newLabel();
    Value before = to.kept(variable, operand);
    Value by = to.operand(operand);
    to.notVoid(by);
    if (assignment.sign() != 0) {
      int a = to.number(before, slow);
      int b = to.number(by, slow);
      intact(assignment.operator(), assignment, Names.COUNTING, assignment.isIntact(), slow);
      to.code.dload(a).dload(b);
      if (assignment.sign() > 0) {
        to.code.dadd();
      } else {
        to.code.dsub();
      }
      setNumber(variable);
      if (to.loops().isQuick()) {
        return;
      }
      to.code.goto_(over);
    }
    to.code.labelBinding(slow);
    to.load(before);
    to.load(by);
    to.frame();
    to.constant(assignment, Names.COUNTING);
    to.help("combined", Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.COUNTING);
    changed(variable);
    to.code.labelBinding(over);
  }

  /** The object on the stack, which other code has computed, is the new value. */
  private void changed(Value variable) {
    to.releasing(() -> {
      int result = to.newObject();
      to.code.astore(result);
      to.afterOthers();
      to.code.aload(result).astore(variable.object());
    });
  }
}
