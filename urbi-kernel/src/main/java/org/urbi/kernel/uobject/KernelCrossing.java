package org.urbi.kernel.uobject;

import static java.util.Objects.requireNonNull;

import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.KernelThreadPin;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
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
    JavaCallState callState = JavaCallState.of(caller.job());
    Frame outer = callState.caller;
    callState.caller = caller;
    if (outer == null) {
      UContext.enter(context);
      KernelThreadPin.pin();
      caller.job().componentCode().enter(function);
    }
    return outer;
  }

  /** The Java code has returned, or thrown something. */
  void back(Frame caller, @Nullable Frame outer) {
    JavaCallState callState = JavaCallState.of(caller.job());
    callState.caller = outer;
    if (outer == null) {
      KernelThreadPin.unpin();
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
      return nativeThread.isCurrent()
          ? nativeThread.ask(() -> inKernel(task))
          : requests.ask(frame -> translated(frame, task));
    }
    if (over) {
      return null;
    }
    Job job = requireNonNull(scheduler.running(), "components are called by jobs");
    JavaCallState callState = JavaCallState.of(job);
    @Nullable Frame caller = callState.caller;
    if (caller == null) {
      return task.apply(Frame.top(interpreter, job, job.lobby(), new FrameLayout()));
    }
    callState.caller = null;
    KernelThreadPin.unpin();
    String function = job.componentCode().enter(null);
    try {
      return translated(caller, task);
    } catch (ControlFlowException e) {
      callState.unwinding = e;
      throw e;
    } finally {
      job.componentCode().enter(function);
      KernelThreadPin.pin();
      callState.caller = caller;
    }
  }

  /**
   * Like {@link #inKernel}, for a task that always has a result.
   *
   * @throws IllegalStateException when the kernel has ended
   */
  <T> T fromKernel(Function<Frame, T> task) {
    T result = inKernel(task);
    if (result == null) {
      throw KernelRequests.ended();
    }
    return result;
  }

  private <T> T translated(Frame frame, Function<Frame, T> task) {
    try {
      return task.apply(frame);
    } catch (UrbiException e) {
      throw new PropagatedUrbiException(text(frame, e), e);
    }
  }

  /** The message of an exception of urbiscript. */
  String text(Frame frame, UrbiException e) {
    try {
      return Utf8Text.toJava(frame.interpreter().asString(frame, e.value()));
    } catch (UrbiException shown) {
      return Problem.UNPRINTABLE.text();
    }
  }
}
