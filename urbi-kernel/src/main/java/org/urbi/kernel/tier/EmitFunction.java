package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_void;

import java.lang.classfile.ClassBuilder;
import java.lang.classfile.ClassFile;
import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.classfile.TypeKind;
import java.lang.constant.ClassDesc;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.node.Node;

/**
 * Emits a function: its body, whose parameters are pairs, and the two ways to it. The interpreter
 * has made a frame with the arguments. Other compiled code passes pairs, and a frame is made when
 * something needs one: what the body calls, or an error.
 */
record EmitFunction(Node body) implements Tier.Emission {
  /** With more parameters a function is not called by passing pairs. */
  static final int MOST_PARAMETERS = 3;

  /** The name of the method that is called with pairs, by code that has its object. */
  static final String CALL = "call";

  /** The name of the same as a static method, by which a function calls itself. */
  static final String DIRECT = "direct";

  private static final String BODY = "body";
  private static final int PAIR = 3;

  // The parameters of the body, before the pairs: the frame, or null if there is none yet; what it
  // is made of, which begins with the frame of who called; the last two are null, and the first two
  // the same, if the interpreter has called.
  private static final int FRAME = 0;
  private static final int BY = 1;
  static final int FUNCTION = 2;
  private static final int SITE = 3;
  static final int SELF = 4;
  static final int BODY_PARAMETERS = 5;

  /** The type of {@link #CALL}. */
  static MethodTypeDesc callType(int parameters) {
    List<ClassDesc> types =
        new ArrayList<>(List.of(Names.FUNCTION, Names.FRAME, Names.SITE, Names.OBJECT));
    return MethodTypeDesc.of(Names.OBJECT, withPairs(types, parameters));
  }

  private static List<ClassDesc> withPairs(List<ClassDesc> types, int parameters) {
    for (int i = 0; i < parameters; i++) {
      types.add(CD_double);
      types.add(Names.OBJECT);
    }
    return types;
  }

  private static MethodTypeDesc bodyType(int parameters) {
    List<ClassDesc> types =
        new ArrayList<>(
            List.of(Names.FRAME, Names.FRAME, Names.FUNCTION, Names.SITE, Names.OBJECT));
    return MethodTypeDesc.of(Names.OBJECT, withPairs(types, parameters));
  }

  @Override
  public void emit(ClassBuilder type, Unit unit) {
    int parameters = unit.known();
    type.withMethodBody(
        BODY,
        bodyType(parameters),
        ClassFile.ACC_STATIC | ClassFile.ACC_PRIVATE,
        code -> body(code, unit));
    type.withMethodBody("run", Tier.RUN, ClassFile.ACC_PUBLIC, code -> run(code, unit, parameters));
    if (parameters <= MOST_PARAMETERS) {
      type.withMethodBody(
          DIRECT,
          callType(parameters),
          ClassFile.ACC_STATIC | ClassFile.ACC_PRIVATE,
          code -> direct(code, unit, parameters));
      type.withMethodBody(
          CALL, callType(parameters), ClassFile.ACC_PUBLIC, code -> call(code, unit, parameters));
    }
  }

  /** The body, and what happens when compiled code has called and it is over. */
  private void body(CodeBuilder code, Unit unit) {
    Emitter to = Emitter.ofFunction(code, unit);
    int answer = to.newObject();
    Label over = code.newLabel();
    Label end = code.newLabel();
    Label start = to.beginRange();
    to.function(body, over);
    code.labelBinding(over);
    code.astore(answer).labelBinding(end);
    Label last = code.newLabel();
    code.aload(SITE).ifnull(last);
    Label leaving = code.newBoundLabel();
    code.aload(FRAME);
    Emitter.help(code, "end", CD_void, Names.FRAME);
    code.labelBinding(last);
    code.aload(answer).areturn();
    Label handler = code.newBoundLabel();
    int thrown = to.newObject();
    Label called = code.newLabel();
    code.astore(thrown).aload(SITE).ifnonnull(called).aload(thrown).athrow();
    code.labelBinding(called).aload(thrown);
    to.frame();
    Emitter.help(code, "left", Names.OBJECT, Names.THROWABLE, Names.FRAME);
    code.astore(answer).goto_(leaving);
    code.exceptionCatchAll(start, end, handler);
  }

  /** The interpreter calls: the parameters are in the frame, and an object is wanted. */
  private static void run(CodeBuilder code, Unit unit, int parameters) {
    int frame = code.parameterSlot(0);
    code.aload(frame).aload(frame).aload(frame);
    Emitter.help(code, "function", Names.FUNCTION, Names.FRAME);
    code.aconst_null().aload(frame);
    Emitter.help(code, "self", Names.OBJECT, Names.FRAME);
    if (parameters > 0) {
      int locals = code.allocateLocal(TypeKind.REFERENCE);
      code.aload(frame);
      Emitter.help(code, "locals", Names.OBJECTS, Names.FRAME);
      code.astore(locals);
      for (int i = 0; i < parameters; i++) {
        code.dconst_0().aload(locals).loadConstant(i);
        unit.constant(code, unit.values().voidObject, Names.OBJECT);
        Emitter.help(code, "local", Names.OBJECT, Names.OBJECTS, CD_int, Names.OBJECT);
      }
    }
    code.invokestatic(unit.owner(), BODY, bodyType(parameters));
    Label number = code.newLabel();
    code.dup().ifnull(number);
    code.areturn();
    code.labelBinding(number);
    code.pop().aload(frame);
    Emitter.help(code, "answer", CD_double, Names.FRAME);
    code.aconst_null();
    unit.constant(code, unit.values(), Names.VALUES);
    Emitter.help(code, "object", Names.OBJECT, CD_double, Names.OBJECT, Names.VALUES);
    code.areturn();
  }

  /** Passes the parameters of a call on. */
  private static void pass(CodeBuilder code, int parameters, int from) {
    for (int i = 0; i < parameters; i++) {
      code.dload(from + i * PAIR).aload(from + i * PAIR + 2);
    }
  }

  private static void call(CodeBuilder code, Unit unit, int parameters) {
    for (int i = 0; i < 4; i++) {
      code.aload(code.parameterSlot(i));
    }
    pass(code, parameters, code.parameterSlot(3) + 1);
    code.invokestatic(unit.owner(), DIRECT, callType(parameters)).areturn();
  }

  /** Compiled code calls. */
  private static void direct(CodeBuilder code, Unit unit, int parameters) {
    int called = code.parameterSlot(0);
    int caller = code.parameterSlot(1);
    int at = code.parameterSlot(2);
    int self = code.parameterSlot(3);
    code.aload(caller).aload(at);
    Emitter.help(code, "enter", CD_void, Names.FRAME, Names.SITE);
    code.aconst_null().aload(caller).aload(called).aload(at).aload(self);
    pass(code, parameters, self + 1);
    code.invokestatic(unit.owner(), BODY, bodyType(parameters)).areturn();
  }
}
