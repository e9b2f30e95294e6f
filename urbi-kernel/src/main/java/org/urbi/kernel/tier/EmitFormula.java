package org.urbi.kernel.tier;

import static java.util.Objects.requireNonNull;

import java.lang.classfile.Label;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Map;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.NumericOperator;
import org.urbi.kernel.node.Variables;
import org.urbi.kernel.object.Symbol;

/**
 * Emits formulas: operators of numbers whose operands are plain variables, literals and such
 * operators. Nothing can happen in between, so it is first asked whether all variables are plain
 * numbers and all operators the library's; then it is computed, and otherwise the interpreter does
 * it.
 */
final class EmitFormula {
  private static final int NO_FORMULA = -1;

  private final Emitter to;
  private final EmitArithmetic arithmetic;

  EmitFormula(Emitter to, EmitArithmetic arithmetic) {
    this.to = to;
    this.arithmetic = arithmetic;
  }

  /** Whether it is a formula that is probably one of numbers. */
  static boolean fits(NumericOperator operator) {
    int left = operators(operator.left());
    int right = operators(operator.right());
    return left >= 0
        && right >= 0
        && (left + right > 0
            || isNumber(operator.left())
            || isNumber(operator.right())
            || operator.isComparison() && !operator.isEquality());
  }

  private static boolean isNumber(Node node) {
    return node instanceof Literals.Number;
  }

  /** How many operators there are in a formula without comparisons. */
  private static int operators(Node node) {
    if (node instanceof NumericOperator operator && !operator.isComparison()) {
      int left = operators(operator.left());
      int right = operators(operator.right());
      return left >= 0 && right >= 0 ? 1 + left + right : NO_FORMULA;
    }
    return isNumber(node) || node instanceof Variables.Local ? 0 : NO_FORMULA;
  }

  Value value(NumericOperator operator) {
    Value result = to.newPair();
    Label slow = to.code.newLabel();
    Label over = to.code.newLabel();
    Formula formula = new Formula(slow);
    formula.check(operator);
    formula.push(operator);
    arithmetic.setNumber(result);
    to.code.goto_(over);
    to.code.labelBinding(slow);
    to.code.aload(to.unknown(operator, false).object()).astore(result.object());
    to.code.labelBinding(over);
    return result;
  }

  /** Emits a comparison, after which the code goes on if it holds. */
  void condition(NumericOperator operator, Label otherwise) {
    Label slow = to.code.newLabel();
    Label over = to.code.newLabel();
    Formula formula = new Formula(slow);
    formula.check(operator);
    formula.push(operator.left());
    formula.push(operator.right());
    arithmetic.jumpUnless(operator, otherwise);
    to.code.goto_(over);
    to.code.labelBinding(slow);
    to.statements().truth(to.unknown(operator, false), otherwise);
    to.code.labelBinding(over);
  }

  /** One formula that is being emitted. */
  private final class Formula {
    private final Label slow;
    private final Map<Symbol, NumericOperator> checked = new HashMap<>();
    private final Map<Integer, Integer> variables = new HashMap<>();
    private final Map<Node, Integer> divisors = new IdentityHashMap<>();

    Formula(Label slow) {
      this.slow = slow;
    }

    /** Jumps if something is not as expected. */
    void check(Node node) {
      if (node instanceof Variables.Local read) {
        variables.computeIfAbsent(read.index(), index -> to.number(to.variable(index), slow));
      } else if (node instanceof NumericOperator operator) {
        if (checked.putIfAbsent(operator.name(), operator) == null) {
          arithmetic.intact(operator.name(), operator, Names.OPERATOR, operator.isIntact(), slow);
        }
        check(operator.left());
        check(operator.right());
        if (operator.divides()) {
          checkDivisor(operator.right());
        }
      }
    }

    /** A division by 0 is an error. */
    private void checkDivisor(Node divisor) {
      if (divisor instanceof Literals.Number number && number.value() != 0) {
        return;
      }
      int slot = to.newNumber();
      push(divisor);
      to.code.dup2().dstore(slot).dconst_0().dcmpl().ifeq(slow);
      divisors.put(divisor, slot);
    }

    /** Pushes the value, as a double. */
    void push(Node node) {
      Integer divisor = divisors.get(node);
      if (divisor != null) {
        to.code.dload(divisor);
      } else if (node instanceof Literals.Number number) {
        to.code.loadConstant(number.value());
      } else if (node instanceof Variables.Local read) {
        to.code.dload(requireNonNull(variables.get(read.index()), "it has been checked"));
      } else if (node instanceof NumericOperator operator) {
        push(operator.left());
        push(operator.right());
        arithmetic.compute(operator);
      }
    }
  }
}
