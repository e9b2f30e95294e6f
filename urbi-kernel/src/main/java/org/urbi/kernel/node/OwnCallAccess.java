package org.urbi.kernel.node;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/** How a compiled function calls itself, without a frame until something needs one. */
abstract class OwnCallAccess extends CallAccess {
  private static final long NO_NUMBER = Double.doubleToRawLongBits(UrbiObject.NO_NUMBER);

  /** The interpreter calls. */
  protected static OwnCalls ownCalls(Frame frame, List<? extends CallSite> places) {
    return new OwnCalls(frame, places);
  }

  /** Other compiled code calls. */
  protected static OwnCalls ownCalls(
      Function called,
      Frame caller,
      CallSite at,
      UrbiObject self,
      List<? extends CallSite> places) {
    return new OwnCalls(caller, called, at, self, places);
  }

  /**
   * Begins a call that the function makes of itself.
   *
   * @param level of the call in which it does so
   */
  protected static void enter(OwnCalls calls, int level, int site, Interpreter interpreter) {
    try {
      interpreter.enter(calls.job, calls.depth + level + 1);
    } catch (UrbiException e) {
      throw located(e, calls.frame(level), calls.place(site).calledSpan());
    }
    calls.call(level, site);
  }

  /** Whether it is that function which calls itself. */
  protected static boolean isOwn(OwnCalls calls, Function function) {
    return calls.function == function;
  }

  protected static Job job(OwnCalls calls) {
    return calls.job;
  }

  protected static UrbiObject self(OwnCalls calls) {
    return calls.self;
  }

  protected static Function function(OwnCalls calls) {
    return calls.function;
  }

  protected static Frame frame(OwnCalls calls, int level) {
    return calls.frame(level);
  }

  /** The frame of a call; null if nobody has needed it until now. */
  protected static @Nullable Frame frameIfAny(OwnCalls calls, int level) {
    return calls.hasFrame(level) ? calls.frame(level) : null;
  }

  /** A call answers with an object; returns what stands for it. */
  protected static double answer(UrbiObject object, OwnCalls calls) {
    calls.answer = object;
    return UrbiObject.NO_NUMBER;
  }

  /** The object with which a call has answered; null if that was a number after all. */
  protected static @Nullable UrbiObject answered(OwnCalls calls) {
    UrbiObject object = calls.answer;
    calls.answer = null;
    return object;
  }

  private static @Nullable UrbiObject answered(double answer, OwnCalls calls) {
    return Double.doubleToRawLongBits(answer) == NO_NUMBER ? answered(calls) : null;
  }

  /** Answers other compiled code, which has called. */
  protected static @Nullable UrbiObject answer(double answer, OwnCalls calls, Frame caller) {
    UrbiObject object = answered(answer, calls);
    if (object == null) {
      setAnswer(answer, caller);
    }
    return object;
  }

  /** Answers the interpreter. */
  protected static UrbiObject answer(double answer, OwnCalls calls, Values values) {
    return object(answer, answered(answer, calls), values);
  }

  /** A call is over. */
  protected static void end(OwnCalls calls, int level) {
    if (calls.hasFrame(level)) {
      endFrame(calls, level);
    }
  }

  private static void endFrame(OwnCalls calls, int level) {
    if (!calls.isOfInterpreter(level)) {
      Frame frame = calls.frame(level);
      calls.forget(level);
      UrbiObject answer = answered(calls);
      end(frame);
      calls.answer = answer;
    }
  }

  /** An exception leaves a call: it answers with the value of a return, or throws again. */
  protected static double left(Throwable leaving, OwnCalls calls, int level) throws Throwable {
    if (calls.isOfInterpreter(level)) {
      throw leaving;
    }
    try {
      Frame frame = calls.frame(level);
      UrbiObject answer = left(leaving, frame);
      end(frame);
      return answer(answer, calls);
    } finally {
      calls.forget(level);
    }
  }
}
