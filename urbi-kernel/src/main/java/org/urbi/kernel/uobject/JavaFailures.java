package org.urbi.kernel.uobject;

import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import urbi.UCastException;

/** Turns failures of Java code into urbiscript errors. */
final class JavaFailures {
  private JavaFailures() {}

  /**
   * The error for what a called function has thrown.
   *
   * @param function its full name
   */
  static RuntimeException inFunction(
      PluggedContext context,
      Frame caller,
      CallSite site,
      String function,
      UrbiObject[] arguments,
      Throwable failure) {
    Errors errors = caller.interpreter().errors();
    return switch (failure) {
      case ControlFlowException unwinding -> unwinding;
      case UrbiException thrown -> thrown;
      case PropagatedUrbiException raised -> raised.original();
      case KernelRefusal refusal ->
          errors.primitive(
              site.isNamed() ? site.calledName() : function,
              Problem.REASON,
              Utf8Text.toUrbi(refusal.reason()));
      case ConversionFailure e when e.getMessage() == null ->
          argument(context, errors, function, arguments, e);
      case CompletionException e
          when e.getCause() instanceof ArgumentFailure elsewhere
              && elsewhere.place() >= 1
              && elsewhere.place() <= arguments.length ->
          argument(
              context,
              errors,
              function,
              elsewhere.place(),
              arguments[elsewhere.place() - 1],
              elsewhere.expected());
      default ->
          errors.primitive(
              site.isNamed() ? site.calledName() : function,
              Problem.REASON,
              Utf8Text.toUrbi(caught(calling(function), failure)));
    };
  }

  private static UrbiException argument(
      PluggedContext context,
      Errors errors,
      String function,
      UrbiObject[] arguments,
      ConversionFailure e) {
    int place = 1;
    while (place <= arguments.length && arguments[place - 1] != e.given()) {
      place++;
    }
    return argument(context, errors, function, place, e.given(), e.expected());
  }

  private static UrbiException argument(
      PluggedContext context,
      Errors errors,
      String function,
      int place,
      UrbiObject given,
      @Nullable String type) {
    UrbiObject expected = type == null ? null : context.interpreter().world().findPrototype(type);
    return errors.argumentType(
        Utf8Text.toUrbi(function),
        place,
        given,
        expected == null ? context.interpreter().values().nil : expected);
  }

  /** The description of a call of a component's function. */
  static String calling(String function) {
    return "calling " + function;
  }

  /**
   * The message for what a component has thrown; its stack trace goes to the log. A component that
   * refuses something with an exception without a stack trace speaks to whoever is told only.
   *
   * @param doing the activity that failed
   */
  static String caught(String doing, Throwable failure) {
    Throwable cause = cause(failure);
    boolean isRefusal = !(cause instanceof Error) && cause.getStackTrace().length == 0;
    if (!(failure instanceof ConversionFailure || isRefusal)) {
      FailureLog.component(doing, failure);
    }
    return Problem.CAUGHT_IN_COMPONENT.text(doing, text(failure));
  }

  /** What was thrown, without what a thread or a promise has wrapped it in. */
  private static Throwable cause(Throwable failure) {
    Throwable cause = failure;
    while ((cause instanceof CompletionException || cause instanceof ExecutionException)
        && cause.getCause() != null) {
      cause = cause.getCause();
    }
    return cause;
  }

  /** The text of a failure. */
  static String text(Throwable failure) {
    Throwable cause = cause(failure);
    if (cause instanceof StackOverflowError) {
      return Problem.STACK_EXHAUSTED.text();
    }
    if (cause instanceof Error) {
      return FailureLog.text(cause);
    }
    String message = cause.getMessage();
    boolean plain =
        cause.getClass() == RuntimeException.class
            || cause.getClass() == Exception.class
            || cause instanceof IllegalStateException
            || cause instanceof IllegalArgumentException
            || cause instanceof ConversionFailure
            || cause instanceof UCastException;
    if (message == null || message.isEmpty()) {
      return cause.getClass().getSimpleName();
    }
    return plain ? message : Problem.NAMED_REASON.text(cause.getClass().getSimpleName(), message);
  }
}
