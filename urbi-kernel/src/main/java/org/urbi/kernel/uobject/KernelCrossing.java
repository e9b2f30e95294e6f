package org.urbi.kernel.uobject;

import static java.util.Objects.requireNonNull;

import java.util.function.Function;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import urbi.UContext;

/**
 * The way from urbiscript into the Java code of components, and from there back into the kernel.
 */
final class KernelCrossing {
  private final UContext context;
  private final Interpreter interpreter;
  private final Scheduler scheduler;
  private final KernelRequests requests;
  private final NativeThread nativeThread;
  private volatile boolean over;

  KernelCrossing(
      UContext context,
      Interpreter interpreter,
      KernelRequests requests,
      NativeThread nativeThread) {
    this.context = context;
    this.interpreter = interpreter;
    this.scheduler = interpreter.scheduler();
    this.requests = requests;
    this.nativeThread = nativeThread;
  }

  /** The kernel ends: nothing more is run in it. */
  void close() {
    over = true;
  }

  boolean isClosed() {
    return over;
  }

  /**
   * Called before urbiscript calls Java code; the result must be passed to {@link #back}.
   *
   * @param function the name of the function, for messages
   */
  @Nullable Frame leave(Frame caller, String function) {
    return leave(caller, null, function);
  }

  /**
   * Called before urbiscript calls Java code of an object.
   *
   * @param self that object in urbiscript
   */
  @Nullable Frame leave(Frame caller, @Nullable UrbiObject self, String function) {
    JavaCallState callState = JavaCallState.of(caller.job());
    Frame outer = callState.caller;
    callState.caller = caller;
    if (outer == null) {
      callState.self = self;
      UContext.enter(context);
      caller.job().componentCode().enter(function);
    }
    return outer;
  }

  /** The Java code has returned, or thrown something. */
  void back(Frame caller, @Nullable Frame outer) {
    JavaCallState callState = JavaCallState.of(caller.job());
    callState.caller = outer;
    if (outer == null) {
      callState.self = null;
    }
    ControlFlowException unwinding = callState.unwinding;
    callState.unwinding = null;
    try {
      if (outer == null) {
        caller.job().componentCode().leave(null);
      }
    } catch (UrbiException overdue) {
      throw unwinding == null ? overdue : unwinding;
    }
    if (unwinding != null) {
      throw unwinding;
    }
  }

  /**
   * Runs a task on urbiscript objects: at once if called on the kernel thread, where it may let
   * others run; otherwise in a job, for which the calling thread waits.
   *
   * @return the result of the task, which may be null; null if the kernel has ended, because
   *     components are still being closed then
   */
  <T> @Nullable T inKernel(Function<Frame, T> task) {
    if (!scheduler.isKernelThread()) {
      return nativeThread.isCurrent() ? nativeThread.ask(() -> atOnce(task)) : requests.ask(task);
    }
    return atOnce(task);
  }

  /**
   * Like {@link #inKernel(Function)}, for a task that other threads can ask for by data.
   *
   * @param what makes the message with that number
   */
  <T> @Nullable T inKernel(
      Function<Frame, T> task, IntFunction<? extends Message.OfComponent> what) {
    return inKernel(task, null, what);
  }

  /**
   * Has the kernel do what is asked of a variable, which other threads can ask for by data.
   *
   * @param slot the variable that the message names by its number
   */
  <T> @Nullable T inKernel(
      Function<Frame, T> task,
      @Nullable PluggedSlot slot,
      IntFunction<? extends Message.OfComponent> what) {
    if (!scheduler.isKernelThread()) {
      return nativeThread.isCurrent()
          ? nativeThread.ask(() -> atOnce(task))
          : requests.ask(what, slot);
    }
    return atOnce(task);
  }

  private <T> @Nullable T atOnce(Function<Frame, T> task) {
    if (over) {
      return null;
    }
    Job job = requireNonNull(scheduler.running(), "components are called by jobs");
    JavaCallState callState = JavaCallState.of(job);
    @Nullable Frame caller = callState.caller;
    if (caller == null) {
      return task.apply(Frame.top(interpreter, job, job.lobby(), new FrameLayout()));
    }
    UrbiObject self = callState.self;
    callState.caller = null;
    String function = job.componentCode().enter(null);
    try {
      return translated(caller, task);
    } catch (ControlFlowException e) {
      callState.unwinding = e;
      throw e;
    } finally {
      job.componentCode().enter(function);
      callState.caller = caller;
      callState.self = self;
    }
  }

  /** The object in urbiscript whose Java code a job executes; null if that is not known. */
  static @Nullable UrbiObject self(Job job) {
    return JavaCallState.of(job).self;
  }

  /**
   * Like {@link #inKernel}, for a task that always has a result.
   *
   * @throws IllegalStateException when the kernel has ended
   */
  <T> T fromKernel(Function<Frame, T> task) {
    return there(inKernel(task));
  }

  /**
   * Like {@link #inKernel(Function, IntFunction)}, for a task that always has a result.
   *
   * @throws IllegalStateException when the kernel has ended
   */
  <T> T fromKernel(Function<Frame, T> task, IntFunction<? extends Message.OfComponent> what) {
    return there(inKernel(task, what));
  }

  /** Has the kernel do what is asked of a variable, and returns its result. */
  <T> T fromKernel(
      Function<Frame, T> task, PluggedSlot slot, IntFunction<? extends Message.OfComponent> what) {
    return there(inKernel(task, slot, what));
  }

  private static <T> T there(@Nullable T result) {
    if (result == null) {
      throw KernelRequests.ended();
    }
    return result;
  }

  /** Runs a task; what urbiscript throws becomes what components catch. */
  static <T> T translated(Frame frame, Function<Frame, T> task) {
    try {
      return task.apply(frame);
    } catch (UrbiException e) {
      throw new PropagatedUrbiException(text(frame, e), e);
    }
  }

  /** The message of an exception of urbiscript. */
  static String text(Frame frame, UrbiException e) {
    try {
      return Utf8Text.toJava(frame.interpreter().asString(frame, e.value()));
    } catch (UrbiException shown) {
      return Problem.UNPRINTABLE.text();
    }
  }
}
