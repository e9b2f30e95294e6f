package org.urbi.kernel.tier;

import static java.util.Objects.requireNonNull;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.Conditionals;
import org.urbi.kernel.node.ForEach;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Loops;
import org.urbi.kernel.node.MessageSend;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.NumericOperator;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.node.TurnCount;
import org.urbi.kernel.node.Variables;

/**
 * Emits the code of one function or loop: what all families of nodes need, and which of them emits
 * a node.
 *
 * <p>The plain variables of the frame are kept in slots of the Java method. They are written to the
 * frame, and read again, around all code that may see the frame; so every construct that is not
 * compiled is simply executed.
 */
final class Emitter extends CodeWriter {
  /** The slots of the parameters of the method that is emitted for a loop. */
  static final int FROM = 2;

  static final int TO = 4;
  static final int ELEMENTS = 6;

  private final @Nullable Doubt doubt;
  private final Survey survey;
  private final List<Value> variables = new ArrayList<>();
  private final EmitArithmetic arithmetic;
  private final EmitVariables assignments;
  private final EmitStatements statements;
  private final EmitSlots slots;
  private final Callees callees;
  private final EmitContainers containers;
  private final EmitMessages messages;
  private final EmitLoops loops;
  private final EmitScopes scopes;
  private final EmitTry tries;

  /** Where a function goes when it is over; null for a loop. */
  private @Nullable Label over;

  private Emitter(CodeBuilder code, Unit unit, Activation activation) {
    super(code, unit, activation);
    this.doubt = unit.doubt();
    this.survey = unit.survey();
    this.slots = new EmitSlots(this, unit);
    this.arithmetic = new EmitArithmetic(this, slots);
    this.assignments = new EmitVariables(this);
    this.statements = new EmitStatements(this);
    this.callees = new Callees(unit);
    this.containers = new EmitContainers(this, slots, callees);
    this.messages = new EmitMessages(this, slots, containers, callees, unit);
    this.loops = new EmitLoops(this);
    this.scopes = new EmitScopes(this);
    this.tries = new EmitTry(this);
  }

  /** For a loop, whose variables are in the frame. */
  static Emitter ofLoop(CodeBuilder code, Unit unit) {
    Emitter to = new Emitter(code, unit, new Activation.OfLoop());
    to.addVariables(0);
    for (int i = 0; i < unit.locals(); i++) {
      if (unit.survey().mayMention(i)) {
        to.read(i);
      }
    }
    return to;
  }

  /** For a function, whose parameters are those of the method, as pairs. */
  static Emitter ofFunction(CodeBuilder code, Unit unit, Activation activation) {
    Emitter to = new Emitter(code, unit, activation);
    for (int i = 0; i < unit.known(); i++) {
      int pair = activation.parameters().size() + 2 * i;
      to.variables.add(new Value(code.parameterSlot(pair), code.parameterSlot(pair + 1), i));
    }
    to.addVariables(unit.known());
    return to;
  }

  /** Variables that have no value yet. */
  private void addVariables(int first) {
    for (int i = first; i < unit.locals(); i++) {
      variables.add(new Value(newNumber(), newObject(), i));
      code.dconst_0().dstore(variables.get(i).number());
      loadVoid();
      code.astore(variables.get(i).object());
    }
  }

  // ------------------------------------------------------------------ what is emitted

  /** Emits a whole function; jumps when it is over, with its answer on the stack. */
  void function(Node body, Label over) {
    this.over = over;
    last(body);
  }

  /** Emits what a function does last, and leaves it with the value of that. */
  void last(Node node) {
    if (!statements.last(node)) {
      answer(lastStatement(node));
    }
  }

  EmitArithmetic arithmetic() {
    return arithmetic;
  }

  EmitSlots slots() {
    return slots;
  }

  EmitStatements statements() {
    return statements;
  }

  Callees callees() {
    return callees;
  }

  EmitLoops loops() {
    return loops;
  }

  EmitScopes scopes() {
    return scopes;
  }

  EmitTry tries() {
    return tries;
  }

  Survey survey() {
    return survey;
  }

  /** Whether somebody may look at the variables when an exception has left this code. */
  boolean isObserved() {
    return unit.guarded();
  }

  /** Leaves a function. */
  void answer(Value value) {
    Label end = requireNonNull(over, "only functions answer");
    if (!value.hasNumber()) {
      load(value);
      answerObject(end);
      return;
    }
    if (value.isVariable() && survey.mayExpose(value.variable())) {
      // Others may ask for the variable when this is over.
      Label unseen = code.newLabel();
      ifExposed(unseen);
      load(value);
      answerObject(end);
      code.labelBinding(unseen);
    }
    if (value.hasObject()) {
      Label number = code.newLabel();
      code.aload(value.object()).ifnull(number).aload(value.object());
      answerObject(end);
      code.labelBinding(number);
    }
    code.dload(value.number());
    answerNumber(end);
  }

  /** Emits a statement, after which jumps of code that is not compiled are looked for. */
  void statement(Node node) {
    releasing(() -> {
      if (!statements.effect(node)) {
        value(node, true);
      }
    });
  }

  /** Emits a statement whose value is used, such as the last one of a function. */
  Value lastStatement(Node node) {
    return value(node, true);
  }

  /** Emits an expression. */
  Value operand(Node node) {
    return value(node, false);
  }

  private Value value(Node node, boolean jumps) {
    if (node instanceof Variables.Local read) {
      return variables.get(read.index());
    }
    if (node instanceof Literals.Number number) {
      code.loadConstant(number.value());
      return storedNumber();
    }
    if (node instanceof Literals.This) {
      self();
      return storedObject();
    }
    Value value = statements.value(node);
    if (value == null) {
      value = expression(node);
    }
    return value == null ? unknown(node, jumps) : value;
  }

  private @Nullable Value expression(Node node) {
    if (node instanceof NumericOperator operator) {
      return arithmetic.value(operator);
    }
    if (node instanceof CompoundAssignment assignment) {
      return compound(assignment);
    }
    if (node instanceof Variables.Declare declaration
        && (EmitVariables.isPlain(declaration) || EmitVariables.isPlainlyShared(declaration))) {
      return assignments.value(declaration);
    }
    if (node instanceof Variables.Assign assignment) {
      return assignments.value(assignment);
    }
    if (node instanceof Slots.Assign assignment) {
      return slots.value(assignment);
    }
    if (node instanceof Slots.Declare declaration && declaration.isPlain()) {
      return slots.value(declaration);
    }
    if (node instanceof Literals.Sequence literal) {
      return containers.value(literal);
    }
    if (node instanceof Variables.Shared shared) {
      return assignments.value(shared);
    }
    if (node instanceof MessageSend.OfLocal call) {
      return messages.value(call);
    }
    return node instanceof MessageSend message ? messages.value(message) : null;
  }

  private @Nullable Value compound(CompoundAssignment assignment) {
    CompoundAssignment.Access access = assignment.access();
    if (access instanceof CompoundAssignment.OfVariable variable) {
      return assignment.local() >= 0
          ? arithmetic.value(assignment)
          : assignments.value(assignment, variable);
    }
    if (access instanceof CompoundAssignment.Slot slot) {
      return slots.value(assignment, slot);
    }
    return access instanceof CompoundAssignment.Element element && element.indices().length == 1
        ? containers.value(assignment, element)
        : null;
  }

  /** Emits a condition, after which the code goes on if it holds. */
  void condition(Node node, Label otherwise) {
    releasing(() -> emitCondition(node, otherwise));
  }

  private void emitCondition(Node node, Label otherwise) {
    if (node instanceof NumericOperator operator && operator.isComparison()) {
      arithmetic.condition(operator, otherwise);
    } else if (node instanceof Conditionals.Logical logical) {
      statements.condition(logical, otherwise);
    } else if (node instanceof Literals.Number number) {
      if (number.value() == 0) {
        code.goto_(otherwise);
      }
    } else {
      statements.truth(operand(node), otherwise);
    }
  }

  /** Emits code that is not compiled: the node is executed. */
  Value unknown(Node node, boolean jumps) {
    if (Survey.isLeaf(node)) {
      execute(node);
      return storedObject();
    }
    Value result = beside(node, () -> execute(node));
    if (jumps) {
      loops.leaveIfAsked(result);
    }
    return result;
  }

  /** Emits a condition that is not compiled; the code goes on behind it if it holds. */
  void unknownCondition(Node node, Label otherwise) {
    int holds = newFlag();
    beside(
        node,
        () -> {
          constant(node, Names.NODE);
          frame();
          place();
          help("holds", ConstantDescs.CD_boolean, Names.NODE, Names.FRAME, Names.NODE);
          code.istore(holds);
          loadVoid();
        });
    code.iload(holds).ifeq(otherwise);
  }

  // ------------------------------------------------------------------ code that sees the frame

  /**
   * Emits code that sees the variables in the frame, and leaves an object on the stack.
   *
   * @param executed what the interpreter may execute then, besides code that is not compiled
   */
  Value beside(Node executed, Runnable emitted) {
    return beside(Survey.of(executed), emitted);
  }

  /** Emits code that sees the variables in the frame, where a survey tells what it may change. */
  Value beside(Survey inside, Runnable emitted) {
    BitSet changed = changedBy(inside);
    for (Value variable : variables) {
      // What it does not mention it does not need, not even later on.
      int index = variable.variable();
      if ((inside.mayMention(index) || survey.isAssignedElsewhere(index)) && mayDiffer(variable)) {
        write(variable);
      }
    }
    scopes.enter();
    int result = newObject();
    Label start = code.newBoundLabel();
    emitted.run();
    Label end = code.newBoundLabel();
    code.astore(result);
    if (isGuarded() && !changed.isEmpty()) {
      // What handles the exception needs the variables as they are now.
      Label over = code.newLabel();
      code.goto_(over);
      Label handler = code.newBoundLabel();
      read(changed);
      code.athrow();
      code.exceptionCatchAll(start, end, handler);
      code.labelBinding(over);
    }
    read(changed);
    return Value.ofObject(result);
  }

  private BitSet changedBy(Survey inside) {
    BitSet changed = new BitSet();
    for (int i = 0; i < variables.size(); i++) {
      changed.set(i, survey.isAssignedElsewhere(i) || inside.mayAssign(i));
    }
    return changed;
  }

  /** Whether a plain number is not always taken for one. */
  boolean isDoubtful() {
    return doubt != null;
  }

  private boolean isGuarded() {
    return unit.guarded() || loops.isHandling() || tries.isHandling();
  }

  /**
   * Other code may have run, or has been left by an exception: if it has unevaluated arguments of
   * this one, it may have assigned.
   */
  void afterOthers() {
    BitSet changed = changedBy(new Survey());
    if (!changed.isEmpty()) {
      Label over = code.newLabel();
      ifExposed(over);
      read(changed);
      code.labelBinding(over);
    }
  }

  /** Jumps unless others may read and assign the variables at any time. */
  private void ifExposed(Label otherwise) {
    frameIfAny();
    help("isExposed", ConstantDescs.CD_boolean, Names.FRAME);
    code.ifeq(otherwise);
  }

  /** A variable has changed: whoever has unevaluated arguments of this code sees it. */
  void afterStore(Value variable) {
    tell(variable, "write");
  }

  /** A variable begins: others may go on with the one that was there before, in another turn. */
  void afterDeclaration(Value variable) {
    tell(variable, "begin");
  }

  private void tell(Value variable, String how) {
    if (survey.mayExpose(variable.variable())) {
      Label over = code.newLabel();
      ifExposed(over);
      put(variable, how);
      code.labelBinding(over);
    }
  }

  /** Writes the variables to the frame that it may not have, or not as they are now. */
  void writeAll() {
    for (Value variable : variables) {
      if (mayDiffer(variable)) {
        write(variable);
      }
    }
  }

  /** Whether the frame may not have the variable, or not as it is now. */
  private boolean mayDiffer(Value variable) {
    return survey.assigns(variable.variable())
        || !unit.isLoop() && variable.variable() < unit.known();
  }

  private void read(BitSet which) {
    which.stream().forEach(this::read);
  }

  /** Writes a variable to the frame, and keeps the object that it may get. */
  private void write(Value variable) {
    put(variable, "write");
  }

  private void put(Value variable, String how) {
    pushPair(variable);
    frame();
    code.loadConstant(variable.variable());
    help(
        how,
        Names.OBJECT,
        ConstantDescs.CD_double,
        Names.OBJECT,
        Names.FRAME,
        ConstantDescs.CD_int);
    code.astore(variable.object());
  }

  private void read(int variable) {
    frame();
    code.loadConstant(variable);
    help("read", Names.OBJECT, Names.FRAME, ConstantDescs.CD_int);
    code.astore(variables.get(variable).object());
  }

  // ------------------------------------------------------------------ values

  Value variable(int index) {
    return variables.get(index);
  }

  /** Pushes the object of a value; a number gets one, which it keeps. */
  void load(Value value) {
    if (!value.hasNumber()) {
      code.aload(value.object());
      return;
    }
    pushPair(value);
    constant(values, Names.VALUES);
    help("object", Names.OBJECT, ConstantDescs.CD_double, Names.OBJECT, Names.VALUES);
    if (value.hasObject()) {
      code.dup().astore(value.object());
    }
  }

  private void pushPair(Value value) {
    code.dload(value.number());
    if (value.hasObject()) {
      code.aload(value.object());
    } else {
      code.aconst_null();
    }
  }

  /**
   * Jumps unless the value is a plain number.
   *
   * @return the slot of its double
   */
  int number(Value value, Label otherwise) {
    int slot = value.number();
    if (!value.hasNumber()) {
      slot = newNumber();
      // The code at the label may come back to where the number is used.
      code.dconst_0().dstore(slot);
    }
    doubt(otherwise);
    if (!value.hasObject()) {
      return slot;
    }
    Label over = code.newLabel();
    if (value.hasNumber()) {
      code.aload(value.object()).ifnull(over);
    }
    code.aload(value.object());
    constant(values.floatShape, Names.SHAPE);
    help("isNumber", ConstantDescs.CD_boolean, Names.OBJECT, Names.SHAPE);
    code.ifeq(otherwise);
    code.aload(value.object());
    help("number", ConstantDescs.CD_double, Names.OBJECT);
    code.dstore(slot);
    code.labelBinding(over);
    return slot;
  }

  /** Jumps every so often, in tests. */
  void doubt(Label otherwise) {
    if (doubt != null) {
      constant(doubt, Names.DOUBT);
      code.invokevirtual(Names.DOUBT, "strikes", MethodTypeDesc.of(ConstantDescs.CD_boolean));
      code.ifne(otherwise);
    }
  }

  /** Throws an error, without a place, if the value is void. */
  void notVoid(Value value) {
    if (!value.hasObject()) {
      return;
    }
    Label over = code.newLabel();
    if (value.hasNumber()) {
      code.aload(value.object()).ifnull(over);
    }
    code.aload(value.object());
    loadVoid();
    code.if_acmpne(over).aload(value.object());
    frame();
    place();
    help("notVoid", ConstantDescs.CD_void, Names.OBJECT, Names.FRAME, Names.NODE);
    code.labelBinding(over);
  }

  /** Copies a value to the slots of a pair. */
  void copy(Value value, Value to) {
    if (value.isVariable()) {
      // There are two of it from now on, which must be the same object.
      load(value);
      code.astore(to.object());
      code.dload(value.number()).dstore(to.number());
      return;
    }
    if (value.hasNumber()) {
      code.dload(value.number()).dstore(to.number());
    }
    if (value.hasObject()) {
      code.aload(value.object());
    } else {
      code.aconst_null();
    }
    code.astore(to.object());
  }

  /** The value as it is now, whatever happens to the variable that it may be. */
  Value kept(Value value, Node before) {
    if (!value.isVariable()
        || Survey.isSimple(before)
        || !(survey.isAssignedElsewhere(value.variable())
            || Survey.of(before).mayAssign(value.variable()))) {
      return value;
    }
    Value copy = newPair();
    copy(value, copy);
    return copy;
  }

  /** The turns of a loop that can be compiled by itself; null for other nodes. */
  static @Nullable TurnCount turns(Node node) {
    if (node instanceof Loops.Sequential loop) {
      return loop.turns();
    }
    return node instanceof ForEach loop && EmitLoops.canCount(loop) ? loop.turns() : null;
  }
}
