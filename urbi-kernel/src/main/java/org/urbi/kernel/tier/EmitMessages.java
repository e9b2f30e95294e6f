package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_boolean;
import static java.lang.constant.ConstantDescs.CD_int;

import java.lang.classfile.Label;
import org.urbi.kernel.node.MessageSend;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Slots;

/** Emits messages, and assignments to slots. */
final class EmitMessages {
  private final Emitter to;

  EmitMessages(Emitter to) {
    this.to = to;
  }

  Value value(MessageSend message) {
    int receiver = to.newObject();
    Node target = message.target();
    if (target == null) {
      to.frame();
      to.help("self", Names.OBJECT, Names.FRAME);
    } else {
      to.load(to.operand(target));
    }
    to.code.astore(receiver);
    int result = to.newObject();
    to.located(message, () -> send(message, receiver, result));
    to.afterOthers();
    return Value.ofObject(result);
  }

  private void send(MessageSend message, int receiver, int result) {
    Node[] arguments = message.argumentNodes();
    int found = to.newObject();
    to.code.aload(receiver);
    to.frame();
    to.constant(message, Names.MESSAGE);
    to.help("find", Names.OBJECT, Names.OBJECT, Names.FRAME, Names.MESSAGE);
    to.code.astore(found);
    if (arguments.length == 0) {
      answer(message, receiver, found);
      to.code.astore(result);
      return;
    }
    Label lazy = to.code.newLabel();
    Label over = to.code.newLabel();
    to.code.aload(found).loadConstant(arguments.length);
    to.help("takes", CD_boolean, Names.OBJECT, CD_int);
    to.code.ifeq(lazy);
    int room = to.newObject();
    to.code.aload(found).loadConstant(arguments.length);
    to.help("room", Names.OBJECTS, Names.OBJECT, CD_int);
    to.code.astore(room);
    for (int i = 0; i < arguments.length; i++) {
      Value argument = to.operand(arguments[i]);
      to.notVoid(argument);
      to.code.aload(room).loadConstant(i);
      to.load(argument);
      to.code.aastore();
    }
    to.code.aload(found).aload(receiver).aload(room).loadConstant(arguments.length);
    to.frame();
    to.constant(message, Names.MESSAGE);
    to.help(
        "call",
        Names.OBJECT,
        Names.OBJECT,
        Names.OBJECT,
        Names.OBJECTS,
        CD_int,
        Names.FRAME,
        Names.MESSAGE);
    to.code.astore(result).goto_(over);
    to.code.labelBinding(lazy);
    Value answer = to.beside(message, () -> answer(message, receiver, found));
    to.code.aload(answer.object()).astore(result);
    to.code.labelBinding(over);
  }

  private void answer(MessageSend message, int receiver, int found) {
    to.code.aload(found).aload(receiver);
    to.frame();
    to.constant(message, Names.MESSAGE);
    to.help("answer", Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.MESSAGE);
  }

  Value value(Slots.Assign assignment) {
    int target = to.newObject();
    to.load(to.operand(assignment.target()));
    to.code.astore(target);
    Value value = to.operand(assignment.value());
    if (value.hasObject()) {
      to.located(assignment, () -> to.notVoid(value));
    }
    to.code.aload(target);
    to.load(value);
    to.frame();
    to.constant(assignment, Names.SLOT_ASSIGNMENT);
    to.help("assign", Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.SLOT_ASSIGNMENT);
    Value result = to.storedObject();
    to.afterOthers();
    return result;
  }
}
