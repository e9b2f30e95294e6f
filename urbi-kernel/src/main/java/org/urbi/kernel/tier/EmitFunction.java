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

  /** The name of the method that does what the function does. */
  static final String BODY = "body";

  private static final int PAIR = 3;

  // The parameters of a call, before the pairs.
  static final int CALLED = 0;
  static final int CALLER = 1;
  static final int AT = 2;
  static final int SELF = 3;
  private static final List<ClassDesc> CALL_PARAMETERS =
      List.of(Names.FUNCTION, Names.FRAME, Names.SITE, Names.OBJECT);

  /** The type of {@link #CALL} and {@link #DIRECT}. */
  static MethodTypeDesc callType(int parameters) {
    return withPairs(Names.OBJECT, CALL_PARAMETERS, parameters);
  }

  /** The type of {@link #BODY}. */
  static MethodTypeDesc bodyType(Activation activation, int parameters) {
    return withPairs(activation.answer(), activation.parameters(), parameters);
  }

  private static MethodTypeDesc withPairs(
      ClassDesc answer, List<ClassDesc> before, int parameters) {
    List<ClassDesc> types = new ArrayList<>(before);
    for (int i = 0; i < parameters; i++) {
      types.add(CD_double);
      types.add(Names.OBJECT);
    }
    return MethodTypeDesc.of(answer, types);
  }

  /** One way of doing that. */
  interface Way {
    Activation activation();

    /** Emits the body, and what happens when it is over. */
    void body(CodeBuilder code);

    /** The interpreter calls: the parameters are in the frame, and an object is wanted. */
    void run(CodeBuilder code);

    /** Compiled code calls. */
    void direct(CodeBuilder code);
  }

  @Override
  public void emit(ClassBuilder type, Unit unit) {
    int parameters = unit.known();
    boolean isCalledWithPairs = parameters <= MOST_PARAMETERS;
    Way way =
        isCalledWithPairs && new Callees(unit).areOnlyTheFunction()
            ? new EmitOwnCalls(body, unit)
            : new Usual(body, unit, new Activation.OfFunction(unit.hasCells()));
    type.withMethodBody(
        BODY,
        bodyType(way.activation(), parameters),
        ClassFile.ACC_STATIC | ClassFile.ACC_PRIVATE,
        way::body);
    type.withMethodBody(ClassFiles.RUN, Tier.RUN, ClassFile.ACC_PUBLIC, way::run);
    if (isCalledWithPairs) {
      type.withMethodBody(
          DIRECT, callType(parameters), ClassFile.ACC_STATIC | ClassFile.ACC_PRIVATE, way::direct);
      type.withMethodBody(
          CALL, callType(parameters), ClassFile.ACC_PUBLIC, code -> call(code, unit));
    }
  }

  private static void call(CodeBuilder code, Unit unit) {
    for (int i = CALLED; i <= SELF; i++) {
      code.aload(code.parameterSlot(i));
    }
    pass(code, unit);
    code.invokestatic(unit.owner(), DIRECT, callType(unit.known())).areturn();
  }

  /** Passes the pairs of a call on. */
  static void pass(CodeBuilder code, Unit unit) {
    int from = code.parameterSlot(SELF) + 1;
    for (int i = 0; i < unit.known(); i++) {
      code.dload(from + i * PAIR).aload(from + i * PAIR + 2);
    }
  }

  /** Passes the parameters that are in a frame. */
  static void passLocals(CodeBuilder code, Unit unit, int frame) {
    if (unit.known() == 0) {
      return;
    }
    int locals = code.allocateLocal(TypeKind.REFERENCE);
    code.aload(frame);
    Emitter.help(code, "locals", Names.OBJECTS, Names.FRAME);
    code.astore(locals);
    for (int i = 0; i < unit.known(); i++) {
      code.dconst_0().aload(locals).loadConstant(i);
      unit.constant(code, unit.values().voidObject, Names.OBJECT);
      Emitter.help(code, "local", Names.OBJECT, Names.OBJECTS, CD_int, Names.OBJECT);
    }
  }

  /** Begins a call. */
  static void enter(CodeBuilder code, Unit unit) {
    code.aload(code.parameterSlot(CALLER)).aload(code.parameterSlot(AT));
    unit.constant(code, unit.frame().interpreter(), Names.INTERPRETER);
    Emitter.help(code, "enter", CD_void, Names.FRAME, Names.SITE, Names.INTERPRETER);
  }

  /** A function of which nothing is known. */
  private record Usual(Node body, Unit unit, Activation.OfFunction activation) implements Way {
    @Override
    public void body(CodeBuilder code) {
      int site = code.parameterSlot(Activation.OfFunction.SITE);
      Emitter to = Emitter.ofFunction(code, unit, activation);
      int answer = to.newObject();
      Label over = code.newLabel();
      Label end = code.newLabel();
      Label start = to.beginRange();
      to.function(body, over);
      code.labelBinding(over);
      code.astore(answer).labelBinding(end);
      Label last = code.newLabel();
      code.aload(site).ifnull(last);
      Label leaving = code.newBoundLabel();
      to.frameIfAny();
      Emitter.help(code, "end", CD_void, Names.FRAME);
      code.labelBinding(last);
      code.aload(answer).areturn();
      Label handler = code.newBoundLabel();
      int thrown = to.newObject();
      Label called = code.newLabel();
      code.astore(thrown).aload(site).ifnonnull(called).aload(thrown).athrow();
      code.labelBinding(called).aload(thrown);
      to.frame();
      Emitter.help(code, "left", Names.OBJECT, Names.THROWABLE, Names.FRAME);
      code.astore(answer).goto_(leaving);
      code.exceptionCatchAll(start, end, handler);
    }

    @Override
    public void run(CodeBuilder code) {
      int frame = code.parameterSlot(0);
      code.aload(frame).aload(frame).aload(frame);
      Emitter.help(code, "function", Names.FUNCTION, Names.FRAME);
      code.aconst_null().aload(frame);
      Emitter.help(code, "self", Names.OBJECT, Names.FRAME);
      passLocals(code, unit, frame);
      callBody(code);
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

    @Override
    public void direct(CodeBuilder code) {
      enter(code, unit);
      code.aconst_null();
      for (int each : new int[] {CALLER, CALLED, AT, SELF}) {
        code.aload(code.parameterSlot(each));
      }
      pass(code, unit);
      callBody(code);
      code.areturn();
    }

    private void callBody(CodeBuilder code) {
      code.invokestatic(unit.owner(), BODY, bodyType(activation, unit.known()));
    }
  }
}
