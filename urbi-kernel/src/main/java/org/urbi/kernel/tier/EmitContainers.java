package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_boolean;
import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_void;

import java.lang.classfile.Label;
import java.util.List;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.KnownSlot;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Shortcut;
import org.urbi.kernel.node.SlotLookup;

/** Emits what functions of the library do with lists and dictionaries, without a call. */
final class EmitContainers {
  private final Emitter to;
  private final EmitSlots slots;
  private final Callees callees;

  EmitContainers(Emitter to, EmitSlots slots, Callees callees) {
    this.to = to;
    this.slots = slots;
    this.callees = callees;
  }

  /** Emits the shortcut; jumps if something is not as expected. */
  void take(Shortcut shortcut, int target, List<Value> arguments, Value result, Label otherwise) {
    switch (shortcut) {
      case ELEMENT -> {
        int index = to.number(arguments.getFirst(), otherwise);
        to.code.aload(target).dload(index);
        to.help("element", Names.OBJECT, Names.OBJECT, CD_double);
        to.code.dup().astore(result.object()).ifnull(otherwise);
      }
      case SET_ELEMENT -> {
        int index = to.number(arguments.getFirst(), otherwise);
        to.load(arguments.getLast());
        to.code.astore(result.object());
        to.code.aload(target).dload(index).aload(result.object());
        to.job();
        to.help("setElement", CD_boolean, Names.OBJECT, CD_double, Names.OBJECT, Names.JOB);
        to.code.ifeq(otherwise);
      }
      case SET_ENTRY -> {
        to.load(arguments.getLast());
        to.code.astore(result.object());
        to.code.aload(target);
        to.load(arguments.getFirst());
        to.code.aload(result.object());
        to.frame();
        to.help("setEntry", CD_boolean, Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME);
        to.code.ifeq(otherwise);
      }
      case APPEND -> {
        to.code.aload(target);
        to.load(arguments.getFirst());
        to.job();
        to.help("append", CD_boolean, Names.OBJECT, Names.OBJECT, Names.JOB);
        to.code.ifeq(otherwise);
        to.code.aload(target).astore(result.object());
      }
      case ENTRY, HAS_ENTRY -> {
        to.code.aload(target);
        to.load(arguments.getFirst());
        to.frame();
        to.help(
            shortcut == Shortcut.ENTRY ? "entry" : "hasEntry",
            Names.OBJECT,
            Names.OBJECT,
            Names.OBJECT,
            Names.FRAME);
        to.code.dup().astore(result.object()).ifnull(otherwise);
      }
      case NOT -> {
        to.code.aload(target);
        to.frame();
        to.help("not", Names.OBJECT, Names.OBJECT, Names.FRAME);
        to.code.dup().astore(result.object()).ifnull(otherwise);
      }
      case SIZE_OF_LIST -> size("sizeOfList", target, result, otherwise);
      case SIZE_OF_TEXT -> size("sizeOfText", target, result, otherwise);
      case SIZE_OF_DICTIONARY -> size("sizeOfDictionary", target, result, otherwise);
    }
  }

  private void size(String helper, int target, Value result, Label otherwise) {
    to.code.aload(target);
    to.help(helper, CD_double, Names.OBJECT);
    to.code.dup2().dstore(result.number()).dconst_0().dcmpl().iflt(otherwise);
    to.code.aconst_null().astore(result.object());
  }

  /** {@code [a, b]}. */
  Value value(Literals.Sequence literal) {
    int elements = to.newObject();
    to.code.loadConstant(literal.elements().length);
    to.help("newElements", Names.ELEMENTS, CD_int);
    to.code.astore(elements);
    for (Node each : literal.elements()) {
      Value element = to.operand(each);
      if (element.hasObject()) {
        to.located(literal, () -> to.notVoid(element));
      }
      to.code.aload(elements);
      to.load(element);
      to.help("add", CD_void, Names.ELEMENTS, Names.OBJECT);
    }
    to.code.aload(elements);
    to.frame();
    to.constant(literal, Names.SEQUENCE);
    to.help("sequence", Names.OBJECT, Names.ELEMENTS, Names.FRAME, Names.SEQUENCE);
    return to.storedObject();
  }

  /** {@code a[i] += b}, {@code a[i]++}. */
  Value value(CompoundAssignment assignment, CompoundAssignment.Element element) {
    Value[] results = new Value[1];
    to.located(
        assignment,
        () -> {
          to.load(to.operand(element.target()));
          Value target = to.storedObject();
          Value given = to.operand(element.indices()[0]);
          to.notVoid(given);
          to.load(given);
          Value index = to.storedObject();
          Value before = before(assignment, element, target, index);
          to.load(to.arithmetic().combined(assignment, before));
          Value after = to.storedObject();
          write(assignment, element, target, index, after);
          results[0] = assignment.operand() == null ? before : after;
        });
    return results[0];
  }

  private Value before(
      CompoundAssignment assignment,
      CompoundAssignment.Element element,
      Value target,
      Value index) {
    Value before = Value.ofObject(to.newObject());
    Label over = to.code.newLabel();
    shortcuts(element.get(), element, target, List.of(index), before, over);
    to.code.aload(target.object()).aload(index.object());
    to.frame();
    to.constant(assignment, Names.COUNTING);
    to.help("before", Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.COUNTING);
    to.code.astore(before.object());
    to.afterOthers();
    to.code.labelBinding(over);
    return before;
  }

  private void write(
      CompoundAssignment assignment,
      CompoundAssignment.Element element,
      Value target,
      Value index,
      Value after) {
    Label over = to.code.newLabel();
    Value written = Value.ofObject(to.newObject());
    shortcuts(element.set(), element, target, List.of(index, after), written, over);
    to.code.aload(target.object()).aload(index.object()).aload(after.object());
    to.frame();
    to.constant(assignment, Names.COUNTING);
    to.help(
        "write", CD_void, Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.COUNTING);
    to.afterOthers();
    to.code.labelBinding(over);
  }

  /** Emits the shortcuts for what has been found until now; jumps when one has done it. */
  private void shortcuts(
      SlotLookup lookup,
      CompoundAssignment.Element element,
      Value target,
      List<Value> arguments,
      Value result,
      Label done) {
    boolean some = false;
    for (KnownSlot place : slots.places(lookup, element.target())) {
      Shortcut shortcut = callees.shortcut(place.code(), arguments.size());
      if (shortcut != null) {
        Label next = to.code.newLabel();
        slots.check(place, target.object(), next);
        take(shortcut, target.object(), arguments, result, next);
        to.code.goto_(done);
        to.code.labelBinding(next);
        some = true;
      }
    }
    if (some) {
      slots.missed();
    }
  }
}
