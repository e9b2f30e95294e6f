package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_void;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.classfile.TypeKind;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.Values;

/**
 * The code of one method that is being emitted, whatever it does: its slots, its constants, the
 * methods that it calls, and where its errors are.
 */
abstract class CodeWriter {
  /** The bytes of an instruction that reads a constant or calls a method. */
  private static final int SHORTEST = 3;

  /**
   * The helpers that execute no code of urbiscript, throw nothing, and let nobody else be able to
   * run; of those that loops call often.
   */
  static final Set<String> QUIET =
      Set.of(
          "append",
          "captured",
          "element",
          "entry",
          "equatesAsBefore",
          "frame",
          "hasEntry",
          "isExposed",
          "isNumber",
          "isSame",
          "job",
          "local",
          "not",
          "number",
          "object",
          "self",
          "setElement",
          "sizeOfList",
          "sizeOfText",
          "sizeOfDictionary");

  private static final int NO_COUNT = -1;

  final CodeBuilder code;
  final Unit unit;
  final Values values;
  final Activation activation;
  private final int job;

  /** How many bytes there are, at least. */
  private int length;

  /** The first slot that nothing is kept in. */
  private int free;

  /** The slot of how many {@code ;} may just pass, while a loop that counts them is emitted. */
  private int passing = NO_COUNT;

  /** An error without a place gets that of this node, while its code is emitted; null for none. */
  private @Nullable Node place;

  /** Emits the beginning of the method. */
  CodeWriter(CodeBuilder code, Unit unit, Activation activation) {
    this.code = code;
    this.unit = unit;
    this.values = unit.values();
    // What has been emitted before was thrown away, because its jumps were too short.
    unit.counting().set(0);
    unit.slots().set(0);
    this.activation = activation;
    this.job = code.allocateLocal(TypeKind.REFERENCE);
    this.free = job + 1;
    activation.job(code);
    code.astore(job);
  }

  boolean isLoopUnit() {
    return unit.isLoop();
  }

  /** Begins a range of code whose exceptions are handled; such a range must not be empty. */
  Label beginRange() {
    Label start = code.newBoundLabel();
    code.nop();
    return start;
  }

  /** Emits code in which an error without a place has that of a node. */
  void located(Node at, Runnable emitted) {
    Node around = place;
    place = at;
    emitted.run();
    place = around;
  }

  /** Whether an error without a place gets one here. */
  boolean isPlaced() {
    return place != null;
  }

  /** Pushes the node whose place an error without a place gets; or null. */
  void place() {
    if (place == null) {
      code.aconst_null();
    } else {
      constant(place, Names.NODE);
    }
  }

  // ------------------------------------------------------------------ counting ";"

  /** From here on the {@code ;} that pass are counted in the code itself. */
  void beginCounting() {
    unit.counting().incrementAndGet();
    passing = newFlag();
    code.iconst_0().istore(passing);
  }

  /** The loop that counts is over. */
  void endCounting() {
    beforeOthers();
    passing = NO_COUNT;
  }

  boolean isCounting() {
    return passing != NO_COUNT;
  }

  /** The slot of how many {@code ;} may just pass; 0 if that has to be asked. */
  int passing() {
    return passing;
  }

  /**
   * Other code may ask from now on how many {@code ;} have passed, or let others run: what has been
   * borrowed is given back.
   */
  void beforeOthers() {
    if (isCounting()) {
      yields();
      code.iload(passing)
          .invokevirtual(Names.YIELDS, "giveBack", MethodTypeDesc.of(CD_void, CD_int));
      code.iconst_0().istore(passing);
    }
  }

  /** Pushes what counts the {@code ;}. */
  void yields() {
    constant(unit.frame().job().scheduler().yields(), Names.YIELDS);
  }

  // ------------------------------------------------------------------ calls

  /** Lets others run; what has been borrowed has been used. */
  void letOthersRun() {
    int counted = passing;
    passing = NO_COUNT;
    callJob("yield");
    passing = counted;
  }

  /** Calls a method of the job that may throw. */
  void callJob(String name) {
    beforeOthers();
    job();
    if (place == null) {
      code.invokevirtual(Names.JOB, name, ConstantDescs.MTD_void);
    } else {
      frame();
      place();
      help(name, CD_void, Names.JOB, Names.FRAME, Names.NODE);
    }
  }

  /** Executes a node. */
  void execute(Node node) {
    beforeOthers();
    constant(node, Names.NODE);
    frame();
    if (place == null) {
      code.invokevirtual(Names.NODE, "execute", MethodTypeDesc.of(Names.OBJECT, Names.FRAME));
    } else {
      place();
      help("execute", Names.OBJECT, Names.NODE, Names.FRAME, Names.NODE);
    }
  }

  // ------------------------------------------------------------------ slots

  /** Emits something, after which the slots that it has taken are free again. */
  void releasing(Runnable emitted) {
    int before = free;
    emitted.run();
    free = before;
  }

  /** How many slots are taken. */
  int taken() {
    return free;
  }

  Value newPair() {
    Value pair = Value.ofPair(newNumber(), newObject());
    code.dconst_0().dstore(pair.number());
    return pair;
  }

  int newNumber() {
    return allocate(2);
  }

  int newObject() {
    return allocate(1);
  }

  int newFlag() {
    return allocate(1);
  }

  /** Takes slots until the statement that is being emitted ends. */
  private int allocate(int slots) {
    int slot = free;
    free += slots;
    if (free > unit.slots().get()) {
      unit.slots().set(free);
    }
    return slot;
  }

  /** The double on the stack. */
  Value storedNumber() {
    int slot = newNumber();
    code.dstore(slot);
    return Value.ofNumber(slot);
  }

  /** The object on the stack. */
  Value storedObject() {
    int slot = newObject();
    code.astore(slot);
    return Value.ofObject(slot);
  }

  Value voidValue() {
    loadVoid();
    return storedObject();
  }

  /** What stands after a jump is never executed, but the Java machine verifies it. */
  Value unreachable() {
    return voidValue();
  }

  void loadVoid() {
    constant(values.voidObject, Names.OBJECT);
  }

  void loadBoolean(boolean value) {
    constant(values.bool(value), Names.OBJECT);
  }

  // ------------------------------------------------------------------ the Java machine

  /** Pushes the frame. That of a function is made here, if nobody has needed it until now. */
  void frame() {
    grow();
    activation.frame(code);
  }

  /** Pushes the frame, or null if nobody has needed it until now. */
  void frameIfAny() {
    activation.frameIfAny(code);
  }

  /** Makes the number on the stack what the function answers with, and jumps to its end. */
  void answerNumber(Label end) {
    beforeOthers();
    activation.answerNumber(code);
    code.goto_(end);
  }

  /** Makes the object on the stack what the function answers with, and jumps to its end. */
  void answerObject(Label end) {
    beforeOthers();
    activation.answerObject(code);
    code.goto_(end);
  }

  /** Pushes the function that is being executed. */
  void function() {
    activation.function(code);
  }

  /** Pushes {@code this} of urbiscript. */
  void self() {
    activation.self(code);
  }

  /** Pushes the job. */
  void job() {
    code.aload(job);
  }

  /** Pushes an object of the kernel. */
  void constant(Object value, ClassDesc type) {
    grow();
    unit.constant(code, value, type);
  }

  /** Calls a method of the superclass. */
  void help(String name, ClassDesc result, ClassDesc... parameters) {
    if (!QUIET.contains(name)) {
      beforeOthers();
    }
    grow();
    unit.helpers().call(code, name, result, parameters);
  }

  /** Gives up as soon as the code is too long: a class with much more could not even be made. */
  private void grow() {
    length += SHORTEST;
    if (length > ClassFiles.MOST_BYTES) {
      throw new TooLong();
    }
  }

  /** Calls a method of the superclass. */
  static void help(CodeBuilder code, String name, ClassDesc result, ClassDesc... parameters) {
    code.invokestatic(Names.COMPILED_CODE, name, MethodTypeDesc.of(result, parameters));
  }
}
