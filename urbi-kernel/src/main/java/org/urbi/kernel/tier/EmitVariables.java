package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_void;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Variables;

/** Emits declarations and assignments of plain variables. */
final class EmitVariables {
  private final Emitter to;

  EmitVariables(Emitter to) {
    this.to = to;
  }

  static boolean isPlain(Variables.Declare declaration) {
    return declaration.place().declaredLocal() >= 0 && !declaration.isTyped();
  }

  /** Whether it declares a variable that closures or other jobs can reach. */
  static boolean isPlainlyShared(Variables.Declare declaration) {
    return declaration.place().declaredLocal() < 0 && !declaration.isTyped();
  }

  /** A variable that closures or other jobs can reach; null, and nothing is emitted, for others. */
  @Nullable Value value(Variables.Shared shared) {
    if (shared.captured() < 0 || to.isLoopUnit()) {
      return null;
    }
    to.function();
    to.code.loadConstant(shared.captured());
    to.constant(to.values.object.world(), Names.WORLD);
    to.help("captured", Names.OBJECT, Names.FUNCTION, CD_int, Names.WORLD);
    return to.storedObject();
  }

  Value value(Variables.Declare declaration) {
    if (declaration.place().declaredLocal() < 0) {
      Value value = stored(declaration.value(), declaration);
      to.frame();
      to.code.aload(value.object());
      to.constant(declaration.place(), Names.PLACE);
      to.help("declare", CD_void, Names.FRAME, Names.OBJECT, Names.PLACE);
      return value;
    }
    Value variable =
        computed(declaration.place().declaredLocal(), declaration.value(), declaration);
    to.afterDeclaration(variable);
    return variable;
  }

  Value value(Variables.Assign assignment) {
    if (assignment.place().local() < 0) {
      Value value = stored(assignment.value(), assignment);
      to.located(assignment, () -> assign(assignment.place(), value));
      return value;
    }
    Value variable = computed(assignment.place().local(), assignment.value(), assignment);
    to.afterStore(variable);
    return variable;
  }

  /** {@code a += b} and {@code a++} of a variable that closures or other jobs can reach. */
  Value value(CompoundAssignment assignment, CompoundAssignment.OfVariable variable) {
    Value[] results = new Value[1];
    to.located(
        assignment,
        () -> {
          Value before = to.operand(variable.variable());
          to.load(to.arithmetic().combined(assignment, before));
          Value after = to.storedObject();
          assign(variable.place(), after);
          results[0] = assignment.operand() == null ? before : after;
        });
    return results[0];
  }

  private void assign(Variables.Place place, Value value) {
    if (place.captured() >= 0 && !to.isLoopUnit()) {
      to.function();
      to.code.loadConstant(place.captured()).aload(value.object());
      to.help("assign", CD_void, Names.FUNCTION, CD_int, Names.OBJECT);
      to.afterOthers();
      return;
    }
    to.frame();
    to.code.aload(value.object());
    to.constant(place, Names.PLACE);
    to.place();
    to.help("assign", CD_void, Names.FRAME, Names.OBJECT, Names.PLACE, Names.NODE);
    to.afterOthers();
  }

  /** The object of a value that is assigned. */
  private Value stored(@Nullable Node node, Node at) {
    if (node == null) {
      return to.voidValue();
    }
    Value value = to.operand(node);
    if (value.hasObject()) {
      to.located(at, () -> to.notVoid(value));
    }
    to.load(value);
    return to.storedObject();
  }

  private Value computed(int index, @Nullable Node node, Node at) {
    Value variable = to.variable(index);
    Value value = node == null ? to.voidValue() : to.operand(node);
    if (node != null && value.hasObject()) {
      to.located(at, () -> to.notVoid(value));
    }
    if (value.variable() != index) {
      to.copy(value, variable);
    }
    return variable;
  }
}
