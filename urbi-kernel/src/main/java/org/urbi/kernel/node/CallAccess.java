package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/**
 * How compiled code calls compiled code: with pairs, and without a frame until something needs one.
 */
abstract class CallAccess extends FrameAccess {
  /** Begins a call. The interpreter is that of the frame: emitted code has it as a constant. */
  protected static void enter(Frame caller, CallSite at, Interpreter interpreter) {
    try {
      interpreter.enter(caller.job, caller.depth + 1);
    } catch (UrbiException e) {
      throw located(e, caller, at.calledSpan());
    }
  }

  /**
   * The frame of a call.
   *
   * @param frame null if nobody has needed it until now: it is made
   */
  protected static Frame frame(
      @Nullable Frame frame, Frame caller, Function called, CallSite at, UrbiObject self) {
    return frame == null
        ? caller.call(at, self, called, Frame.NO_ARGUMENTS, FrameLayout.NO_CELLS)
        : frame;
  }

  /** The frame of a call of a function with variables that closures or other jobs can reach. */
  protected static Frame frameWithCells(
      @Nullable Frame frame, Frame caller, Function called, CallSite at, UrbiObject self) {
    return frame == null ? caller.call(at, self, called, Frame.NO_ARGUMENTS) : frame;
  }

  /** The function that runs in a frame of one. */
  // No null check, for speed: only the code of a function asks.
  @SuppressWarnings("NullAway")
  protected static Function function(Frame frame) {
    return frame.function;
  }

  /** An exception leaves a call: it answers with the value of a return, or throws again. */
  protected static UrbiObject left(Throwable leaving, Frame frame) throws Throwable {
    try {
      if (leaving instanceof NonLocalExit.Return
          || leaving instanceof UrbiException
          || leaving instanceof TagStop) {
        return Function.left(frame, (RuntimeException) leaving);
      }
      throw leaving;
    } catch (UrbiException e) {
      end(frame);
      throw locatedByCaller(e, frame);
    } catch (Throwable t) {
      end(frame);
      throw t;
    }
  }

  private static UrbiException locatedByCaller(UrbiException exception, Frame frame) {
    return frame.caller == null || frame.site == null
        ? exception
        : located(exception, frame.caller, frame.site.calledSpan());
  }

  /**
   * A call is over.
   *
   * @param frame null if nobody has needed it
   */
  protected static void end(@Nullable Frame frame) {
    if (frame != null && frame.scopeEnd != null) {
      try {
        ScopeEnd.leave(frame, null);
      } catch (UrbiException e) {
        throw locatedByCaller(e, frame);
      }
    }
  }

  /**
   * Makes sure that a scope has been entered.
   *
   * @param frame null if nobody has needed it until now
   * @param around what this has answered before, or {@link ScopeEnd#NOT_ENTERED}
   * @return for {@link #leaveScope}
   */
  protected static @Nullable ScopeEnd enterScope(@Nullable Frame frame, @Nullable ScopeEnd around) {
    return around == ScopeEnd.NOT_ENTERED ? ScopeEnd.enter(frame) : around;
  }

  /** A scope is left, in whatever way. */
  protected static void leaveScope(@Nullable Frame frame, @Nullable ScopeEnd around) {
    if (around != ScopeEnd.NOT_ENTERED) {
      ScopeEnd.leave(frame, around);
    }
  }

  /** Answers a call with a number; it is in the frame of who has called. */
  protected static void setAnswer(double number, Frame frame) {
    frame.answer = number;
  }

  protected static double answer(Frame frame) {
    return frame.answer;
  }

  /** Whether that is a function with that code, whose calls change neither target nor lobby. */
  protected static boolean isFunction(UrbiObject value, Function.Body body) {
    return value instanceof Function function && function.body() == body && function.isUnbound();
  }

  /** The value of a variable that the function has captured. */
  protected static UrbiObject captured(Function running, int index, World world) {
    Cell cell = running.captured()[index];
    Dependencies.Tracker tracker = world.tracker;
    return tracker == null ? cell.get() : cell.getTracked(tracker);
  }

  /** Assigns a variable that the function has captured. */
  protected static void assign(Function running, int index, UrbiObject value) {
    running.captured()[index].set(value);
  }
}
