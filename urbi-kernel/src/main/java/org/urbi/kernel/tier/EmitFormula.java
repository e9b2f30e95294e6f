package org.urbi.kernel.tier;

import static java.util.Objects.requireNonNull;

import java.lang.classfile.Label;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.KnownSlot;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.MessageSend;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.NumericOperator;
import org.urbi.kernel.node.SlotLookup;
import org.urbi.kernel.node.Variables;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;

/**
 * Emits formulas: operators of numbers whose operands are plain variables, literals, plain slots of
 * such variables, and such operators. Nothing can happen in between, so it is first asked whether
 * all variables and slots are plain numbers and all operators the library's; then it is computed,
 * and otherwise the interpreter does it.
 */
final class EmitFormula {
  private static final int NO_FORMULA = -1;

  private final Emitter to;
  private final EmitArithmetic arithmetic;
  private final EmitSlots slots;

  /** The slots that may be read in a formula. */
  private final Map<SlotLookup, Optional<KnownSlot>> known = new IdentityHashMap<>();

  EmitFormula(Emitter to, EmitArithmetic arithmetic, EmitSlots slots) {
    this.to = to;
    this.arithmetic = arithmetic;
    this.slots = slots;
  }

  /** Whether it is a formula that is probably one of numbers. */
  boolean fits(NumericOperator operator) {
    int left = operators(operator.left());
    int right = operators(operator.right());
    return left >= 0
        && right >= 0
        && (left + right > 0
            || isNumber(operator.left())
            || isNumber(operator.right())
            || operator.isComparison() && !operator.isEquality()
            || isSubtraction(operator))
        && (isOfNumbers(operator) || !readsSlots(operator));
  }

  private static boolean isNumber(Node node) {
    return node instanceof Literals.Number;
  }

  /** Strings are only added. */
  private static boolean isSubtraction(NumericOperator operator) {
    return !operator.isComparison() && !operator.name().name().equals("+");
  }

  /** Whether there is more in a formula than what is done with strings, too. */
  private static boolean isOfNumbers(Node node) {
    return isNumber(node)
        || node instanceof NumericOperator operator
            && (isSubtraction(operator)
                || operator.isComparison() && !operator.isEquality()
                || isOfNumbers(operator.left())
                || isOfNumbers(operator.right()));
  }

  private static boolean readsSlots(Node node) {
    return node instanceof MessageSend
        || node instanceof NumericOperator operator
            && (readsSlots(operator.left()) || readsSlots(operator.right()));
  }

  /** The slot that a message just reads, of a variable or of the target; null for others. */
  private @Nullable KnownSlot slot(MessageSend message) {
    return message.argumentNodes().length == 0 ? slot(message.target(), message.lookup()) : null;
  }

  private @Nullable KnownSlot slot(@Nullable Node target, SlotLookup lookup) {
    return known.computeIfAbsent(lookup, of -> find(target, of)).orElse(null);
  }

  private Optional<KnownSlot> find(@Nullable Node target, SlotLookup lookup) {
    if (target != null
        && !(target instanceof Literals.This)
        && !(target instanceof Variables.Local)) {
      return Optional.empty();
    }
    List<KnownSlot> places = slots.places(lookup, target);
    return places.size() == 1 && places.getFirst().mayBeNumber()
        ? Optional.of(places.getFirst())
        : Optional.empty();
  }

  /** How many operators there are in a formula without comparisons. */
  private int operators(Node node) {
    if (node instanceof NumericOperator operator && !operator.isComparison()) {
      int left = operators(operator.left());
      int right = operators(operator.right());
      return left >= 0 && right >= 0 ? 1 + left + right : NO_FORMULA;
    }
    return isNumber(node)
            || node instanceof Variables.Local
            || node instanceof MessageSend message && slot(message) != null
        ? 0
        : NO_FORMULA;
  }

  Value value(NumericOperator operator) {
    Value result = to.newPair();
    Label slow = to.loops().unexpected(operator);
    Formula formula = new Formula(slow);
    formula.check(operator);
    formula.push(operator);
    arithmetic.setNumber(result);
    if (to.loops().isQuick()) {
      return result;
    }
    Label over = to.code.newLabel();
    to.code.goto_(over);
    to.code.labelBinding(slow);
    to.releasing(() -> {
      countMiss(operator);
      to.code.aload(to.unknown(operator, false).object()).astore(result.object());
    });
    to.code.labelBinding(over);
    return result;
  }

  /** Emits a comparison, after which the code goes on if it holds. */
  void condition(NumericOperator operator, Label otherwise) {
    Label slow = to.loops().unexpected(operator);
    Formula formula = new Formula(slow);
    formula.check(operator);
    formula.push(operator.left());
    formula.push(operator.right());
    arithmetic.jumpUnless(operator, otherwise);
    if (to.loops().isQuick()) {
      return;
    }
    Label over = to.code.newLabel();
    to.code.goto_(over);
    to.code.labelBinding(slow);
    to.releasing(() -> {
      countMiss(operator);
      to.unknownCondition(operator, otherwise);
    });
    to.code.labelBinding(over);
  }

  /**
   * Emits {@code a.x += b} and {@code a.x++}, whose value nobody uses, for numbers.
   *
   * @return whether it has done so; otherwise nothing is emitted
   */
  boolean count(CompoundAssignment assignment, CompoundAssignment.Slot slot) {
    Node operand = assignment.operand();
    KnownSlot place = slot(slot.target(), slot.lookup());
    Shape shape = place == null ? null : place.ownShape();
    if (place == null
        || shape == null
        || shape != slot.writer().knownShape()
        || assignment.sign() == 0
        || operand != null && (operators(operand) < 0 || !isPlain(assignment, operand))) {
      return false;
    }
    Label slow = to.loops().unexpected(assignment);
    Formula formula = new Formula(slow);
    Slot read = Slot.of(slot.target(), slot.lookup());
    int before = formula.check(read, place);
    arithmetic.intact(
        assignment.operator(), assignment, Names.COUNTING, assignment.isIntact(), slow);
    if (operand != null) {
      formula.check(operand);
    }
    to.code.dload(before);
    if (operand == null) {
      to.code.loadConstant((double) assignment.sign()).dadd();
    } else {
      formula.push(operand);
      if (assignment.sign() > 0) {
        to.code.dadd();
      } else {
        to.code.dsub();
      }
    }
    int after = to.storedNumber().number();
    slots.setNumber(shape, place.index(), formula.target(read), after, slow);
    if (to.loops().isQuick()) {
      return true;
    }
    Label over = to.code.newLabel();
    to.code.goto_(over);
    to.code.labelBinding(slow);
    to.releasing(() -> {
      slots.missed();
      to.unknown(assignment, false);
    });
    to.code.labelBinding(over);
    return true;
  }

  /** Whether a slot is probably one of numbers: strings are only added. */
  private static boolean isPlain(CompoundAssignment assignment, Node operand) {
    return assignment.sign() < 0 || isOfNumbers(operand);
  }

  private void countMiss(NumericOperator operator) {
    if (readsSlots(operator)) {
      slots.missed();
    }
  }

  /**
   * A slot that is read.
   *
   * @param variable whose slot; -1 for the target of the code
   */
  private record Slot(int variable, Symbol name) {
    static Slot of(@Nullable Node target, SlotLookup lookup) {
      return new Slot(target instanceof Variables.Local read ? read.index() : -1, lookup.name());
    }

    // The methods that a record has by itself are made by the Java machine when they are first
    // called: 20 ms.

    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Slot slot && variable == slot.variable && name.equals(slot.name);
    }

    @Override
    public int hashCode() {
      return 31 * variable + name.hashCode();
    }
  }

  /** One formula that is being emitted. */
  private final class Formula {
    private final Label slow;
    private final Map<Symbol, NumericOperator> checked = new HashMap<>();
    private final Map<Integer, Integer> variables = new HashMap<>();
    private final Map<Slot, Integer> read = new HashMap<>();
    private final Map<Integer, Integer> targets = new HashMap<>();
    private final Map<Node, Integer> divisors = new IdentityHashMap<>();

    Formula(Label slow) {
      this.slow = slow;
    }

    /** Jumps if something is not as expected. */
    void check(Node node) {
      if (node instanceof Variables.Local local) {
        variables.computeIfAbsent(local.index(), index -> to.number(to.variable(index), slow));
      } else if (node instanceof MessageSend message) {
        KnownSlot place = requireNonNull(slot(message), "it is part of the formula");
        check(Slot.of(message.target(), message.lookup()), place);
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

    /** Jumps unless the slot is there, and has a plain number; returns where that is then. */
    int check(Slot slot, KnownSlot place) {
      Integer known = read.get(slot);
      if (known == null) {
        if (read.isEmpty()) {
          slots.untracked(slow);
        }
        known = slots.plainNumber(place, target(slot), slow);
        read.put(slot, known);
      }
      return known;
    }

    /** Where the object is whose slot is read, which is no number without an object. */
    int target(Slot slot) {
      return targets.computeIfAbsent(
          slot.variable(),
          variable -> {
            if (variable < 0) {
              return self();
            }
            int object = to.variable(variable).object();
            to.code.aload(object).ifnull(slow);
            return object;
          });
    }

    private int self() {
      int self = to.newObject();
      to.self();
      to.code.astore(self);
      return self;
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
      } else if (node instanceof Variables.Local local) {
        to.code.dload(requireNonNull(variables.get(local.index()), "it has been checked"));
      } else if (node instanceof MessageSend message) {
        to.code.dload(
            requireNonNull(
                read.get(Slot.of(message.target(), message.lookup())), "it has been checked"));
      } else if (node instanceof NumericOperator operator) {
        push(operator.left());
        push(operator.right());
        arithmetic.compute(operator);
      }
    }
  }
}
