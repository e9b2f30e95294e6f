package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_void;

import java.lang.classfile.CodeBuilder;
import java.lang.constant.ClassDesc;
import java.util.List;
import org.urbi.kernel.node.CallSite;

/** What emitted code is executed for: how it gets at that by the parameters of its method. */
sealed interface Activation {
  /** Pushes the frame, which is made if nobody has needed it until now. */
  void frame(CodeBuilder code);

  /** Pushes the frame, or null if nobody has needed it until now. */
  void frameIfAny(CodeBuilder code);

  /** Pushes the function that is being executed. */
  void function(CodeBuilder code);

  /** Pushes {@code this} of urbiscript. */
  void self(CodeBuilder code);

  /** Pushes the job. */
  void job(CodeBuilder code);

  /** Makes the number on the stack what the body answers with; only functions answer. */
  void answerNumber(CodeBuilder code);

  /** Makes the object on the stack what the body answers with; only functions answer. */
  void answerObject(CodeBuilder code);

  /** What the method of the body answers with. */
  ClassDesc answer();

  /** The types of the parameters that tell, of a method which has others behind them. */
  List<ClassDesc> parameters();

  /** The turns of a loop, in the frame of a function or of the top level. */
  record OfLoop() implements Activation {
    private static final int FRAME = 0;

    @Override
    public void frame(CodeBuilder code) {
      code.aload(code.parameterSlot(FRAME));
    }

    @Override
    public void frameIfAny(CodeBuilder code) {
      frame(code);
    }

    @Override
    public void function(CodeBuilder code) {
      frame(code);
      Emitter.help(code, "function", Names.FUNCTION, Names.FRAME);
    }

    @Override
    public void self(CodeBuilder code) {
      frame(code);
      Emitter.help(code, "self", Names.OBJECT, Names.FRAME);
    }

    @Override
    public void job(CodeBuilder code) {
      frame(code);
      Emitter.help(code, "job", Names.JOB, Names.FRAME);
    }

    @Override
    public void answerNumber(CodeBuilder code) {
      throw new UnsupportedOperationException();
    }

    @Override
    public void answerObject(CodeBuilder code) {
      throw new UnsupportedOperationException();
    }

    @Override
    public ClassDesc answer() {
      return Names.OBJECT;
    }

    @Override
    public List<ClassDesc> parameters() {
      return List.of(Names.FRAME);
    }
  }

  /**
   * A function. Its parameters, before the pairs: the frame, or null if there is none yet; what it
   * is made of, which begins with the frame of who called; the last two are null, and the first two
   * the same, if the interpreter has called.
   *
   * @param hasCells whether closures or other jobs can reach variables of it
   */
  record OfFunction(boolean hasCells) implements Activation {
    static final int FRAME = 0;
    private static final int BY = 1;
    private static final int FUNCTION = 2;
    static final int SITE = 3;
    private static final int SELF = 4;

    @Override
    public void frame(CodeBuilder code) {
      for (int i = FRAME; i <= SELF; i++) {
        code.aload(code.parameterSlot(i));
      }
      Emitter.help(
          code,
          hasCells ? "frameWithCells" : "frame",
          Names.FRAME,
          Names.FRAME,
          Names.FRAME,
          Names.FUNCTION,
          Names.SITE,
          Names.OBJECT);
      code.dup().astore(code.parameterSlot(FRAME));
    }

    @Override
    public void frameIfAny(CodeBuilder code) {
      code.aload(code.parameterSlot(FRAME));
    }

    @Override
    public void function(CodeBuilder code) {
      code.aload(code.parameterSlot(FUNCTION));
    }

    @Override
    public void self(CodeBuilder code) {
      code.aload(code.parameterSlot(SELF));
    }

    @Override
    public void job(CodeBuilder code) {
      code.aload(code.parameterSlot(BY));
      Emitter.help(code, "job", Names.JOB, Names.FRAME);
    }

    @Override
    public void answerNumber(CodeBuilder code) {
      code.aload(code.parameterSlot(BY));
      Emitter.help(code, "setAnswer", CD_void, CD_double, Names.FRAME);
      code.aconst_null();
    }

    @Override
    public void answerObject(CodeBuilder code) {
      // It is the answer.
    }

    /** Null stands for a number, which is in the frame of who has called. */
    @Override
    public ClassDesc answer() {
      return Names.OBJECT;
    }

    @Override
    public List<ClassDesc> parameters() {
      return List.of(Names.FRAME, Names.FRAME, Names.FUNCTION, Names.SITE, Names.OBJECT);
    }
  }

  /**
   * A function that calls itself. Its parameters, before the pairs: all such calls, and how many of
   * them are around this one.
   *
   * @param places where the function calls itself
   */
  record OfItself(List<CallSite> places) implements Activation {
    private static final int CALLS = 0;
    private static final int LEVEL = 1;

    /** Nothing has been emitted yet. */
    void begin() {
      places.clear();
    }

    /** The number of a place where the function calls itself. */
    int number(CallSite place) {
      places.add(place);
      return places.size() - 1;
    }

    @Override
    public List<ClassDesc> parameters() {
      return List.of(Names.OWN_CALLS, CD_int);
    }

    /** Pushes what is said of all such calls. */
    void calls(CodeBuilder code) {
      code.aload(code.parameterSlot(CALLS));
    }

    /** Pushes that, and how many calls are around this one. */
    void place(CodeBuilder code) {
      calls(code);
      code.iload(code.parameterSlot(LEVEL));
    }

    @Override
    public void frame(CodeBuilder code) {
      place(code);
      Emitter.help(code, "frame", Names.FRAME, Names.OWN_CALLS, CD_int);
    }

    @Override
    public void frameIfAny(CodeBuilder code) {
      place(code);
      Emitter.help(code, "frameIfAny", Names.FRAME, Names.OWN_CALLS, CD_int);
    }

    @Override
    public void function(CodeBuilder code) {
      calls(code);
      Emitter.help(code, "function", Names.FUNCTION, Names.OWN_CALLS);
    }

    @Override
    public void self(CodeBuilder code) {
      calls(code);
      Emitter.help(code, "self", Names.OBJECT, Names.OWN_CALLS);
    }

    @Override
    public void job(CodeBuilder code) {
      calls(code);
      Emitter.help(code, "job", Names.JOB, Names.OWN_CALLS);
    }

    @Override
    public void answerNumber(CodeBuilder code) {
      // It is the answer.
    }

    @Override
    public void answerObject(CodeBuilder code) {
      calls(code);
      Emitter.help(code, "answer", CD_double, Names.OBJECT, Names.OWN_CALLS);
    }

    /** A number that no computation has stands for an object, which is kept by all the calls. */
    @Override
    public ClassDesc answer() {
      return CD_double;
    }
  }
}
