package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_List;
import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_void;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.classfile.TypeKind;
import java.util.ArrayList;
import org.urbi.kernel.node.Node;

/**
 * Emits a function that calls nobody but itself: these calls have no frames until something needs
 * one, and answer with a number that is in no memory.
 */
record EmitOwnCalls(Node body, Unit unit, Activation.OfItself activation)
    implements EmitFunction.Way {
  EmitOwnCalls(Node body, Unit unit) {
    this(body, unit, new Activation.OfItself(new ArrayList<>()));
  }

  @Override
  public void body(CodeBuilder code) {
    activation.begin();
    Emitter to = Emitter.ofFunction(code, unit, activation);
    int answer = to.newNumber();
    Label over = code.newLabel();
    Label start = to.beginRange();
    to.function(body, over);
    code.labelBinding(over);
    code.dstore(answer);
    Label end = code.newBoundLabel();
    activation.place(code);
    Emitter.help(code, "end", CD_void, Names.OWN_CALLS, CD_int);
    code.dload(answer).dreturn();
    Label handler = code.newBoundLabel();
    activation.place(code);
    Emitter.help(code, "left", CD_double, Names.THROWABLE, Names.OWN_CALLS, CD_int);
    code.dreturn();
    code.exceptionCatchAll(start, end, handler);
  }

  @Override
  public void run(CodeBuilder code) {
    int frame = code.parameterSlot(0);
    code.aload(frame);
    unit.constant(code, activation.places(), CD_List);
    Emitter.help(code, "ownCalls", Names.OWN_CALLS, Names.FRAME, CD_List);
    int calls = begin(code);
    EmitFunction.passLocals(code, unit, frame);
    callBody(code);
    code.aload(calls);
    unit.constant(code, unit.values(), Names.VALUES);
    Emitter.help(code, "answer", Names.OBJECT, CD_double, Names.OWN_CALLS, Names.VALUES);
    code.areturn();
  }

  @Override
  public void direct(CodeBuilder code) {
    EmitFunction.enter(code, unit);
    for (int i = EmitFunction.CALLED; i <= EmitFunction.SELF; i++) {
      code.aload(code.parameterSlot(i));
    }
    unit.constant(code, activation.places(), CD_List);
    Emitter.help(
        code,
        "ownCalls",
        Names.OWN_CALLS,
        Names.FUNCTION,
        Names.FRAME,
        Names.SITE,
        Names.OBJECT,
        CD_List);
    int calls = begin(code);
    EmitFunction.pass(code, unit);
    callBody(code);
    code.aload(calls).aload(code.parameterSlot(EmitFunction.CALLER));
    Emitter.help(code, "answer", Names.OBJECT, CD_double, Names.OWN_CALLS, Names.FRAME);
    code.areturn();
  }

  /** Leaves the calls, which are on the stack, and the level of the first one there. */
  private static int begin(CodeBuilder code) {
    int calls = code.allocateLocal(TypeKind.REFERENCE);
    code.dup().astore(calls).iconst_0();
    return calls;
  }

  private void callBody(CodeBuilder code) {
    code.invokestatic(
        unit.owner(), EmitFunction.BODY, EmitFunction.bodyType(activation, unit.known()));
  }
}
