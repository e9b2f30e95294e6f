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
 * has made a frame with the arguments; other compiled code passes pairs, and a frame is made here.
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

  /** The type of {@link #CALL}. */
  static MethodTypeDesc callType(int parameters) {
    List<ClassDesc> types =
        new ArrayList<>(List.of(Names.FUNCTION, Names.FRAME, Names.MESSAGE, Names.OBJECT));
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
    return MethodTypeDesc.of(
        Names.OBJECT, withPairs(new ArrayList<>(List.of(Names.FRAME)), parameters));
  }

  @Override
  public void emit(ClassBuilder type, Unit unit) {
    int parameters = unit.known();
    type.withMethodBody(
        BODY,
        bodyType(parameters),
        ClassFile.ACC_STATIC | ClassFile.ACC_PRIVATE,
        code -> Emitter.ofFunction(code, unit).function(body));
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

  /** The interpreter calls: the parameters are in the frame, and an object is wanted. */
  private static void run(CodeBuilder code, Unit unit, int parameters) {
    int frame = code.parameterSlot(0);
    code.aload(frame);
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
    int caller = code.parameterSlot(1);
    int frame = code.allocateLocal(TypeKind.REFERENCE);
    int answer = code.allocateLocal(TypeKind.REFERENCE);
    for (int i = 0; i < 4; i++) {
      code.aload(code.parameterSlot(i));
    }
    Emitter.help(
        code, "enter", Names.FRAME, Names.FUNCTION, Names.FRAME, Names.MESSAGE, Names.OBJECT);
    code.astore(frame);
    Label start = code.newBoundLabel();
    code.aload(frame);
    pass(code, parameters, code.parameterSlot(3) + 1);
    code.invokestatic(unit.owner(), BODY, bodyType(parameters)).astore(answer);
    Label end = code.newBoundLabel();
    Label over = code.newBoundLabel();
    code.aload(frame);
    Emitter.help(code, "end", CD_void, Names.FRAME);
    Label object = code.newLabel();
    code.aload(answer).ifnonnull(object);
    code.aload(frame);
    Emitter.help(code, "answer", CD_double, Names.FRAME);
    code.aload(caller);
    Emitter.help(code, "setAnswer", CD_void, CD_double, Names.FRAME);
    code.labelBinding(object);
    code.aload(answer).areturn();
    Label handler = code.newBoundLabel();
    code.aload(frame);
    Emitter.help(code, "left", Names.OBJECT, Names.THROWABLE, Names.FRAME);
    code.astore(answer).goto_(over);
    code.exceptionCatchAll(start, end, handler);
  }
}
