package org.urbi.kernel;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.ProblemKind;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.library.code.LoadedFiles;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.ErrorStyle;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.Defects;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.advice.Advice;
import org.urbi.lang.advice.SyntaxAdvice;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.source.Span;

/** Shows errors that no code has caught, as the manual does. */
final class ErrorText {
  private ErrorText() {}

  /**
   * Reports an exception that nobody has caught.
   *
   * @param files which of them are the library's
   * @param job null if it was thrown between the turns of the jobs
   */
  static void tell(
      Interpreter interpreter, LoadedFiles files, @Nullable Job job, Throwable failure) {
    if (job == null) {
      FailureLog.internal("the kernel thread", failure);
      return;
    }
    if (isInternal(failure)) {
      FailureLog.internal("job " + job.name(), failure);
    }
    if (job.lobby() instanceof UrbiLobby lobby && lobby.isInstance()) {
      if (lobby.hasShell() && !(failure instanceof ControlFlowException)) {
        lobby.shell().failed();
      }
      try {
        report(interpreter, files, job, lobby, failure);
      } catch (ControlFlowException unwinding) {
        throw unwinding;
      } catch (Throwable unable) {
        FailureLog.internal("showing an error", unable);
        Diagnostics.error(lobby.output(), FailureLog.text(unable));
      }
    }
  }

  /** What a remote process is told whose request has failed; in a job. A bug of ours is logged. */
  static String ofRequest(Interpreter interpreter, RuntimeException failure) {
    return failure instanceof UrbiException thrown
        ? describe(interpreter, thrown)
        : Defects.text("a request of a remote process", failure);
  }

  /** What code has thrown, for people; in a job. */
  static String describe(Interpreter interpreter, UrbiException thrown) {
    Job job = requireNonNull(interpreter.scheduler().running(), "asked in a job");
    return interpreter.asString(
        Frame.top(interpreter, job, job.lobby(), new FrameLayout()), thrown.value());
  }

  /**
   * Whether a failure is a bug of ours, rather than an error of the user's code or an exhausted
   * resource.
   */
  private static boolean isInternal(Throwable failure) {
    return !(failure instanceof UrbiException
        || failure instanceof ControlFlowException
        || failure instanceof StackOverflowError
        || failure instanceof OutOfMemoryError);
  }

  /** Sends an error to a lobby. */
  private static void report(
      Interpreter interpreter, LoadedFiles files, Job job, UrbiLobby lobby, Throwable failure) {
    Output output = lobby.output();
    switch (failure) {
      case UrbiException e when isCounted(interpreter, job, lobby, e) -> lobby.failures().add(e);
      case UrbiException e -> {
        String place = isPlaced(interpreter, e.value()) ? Diagnostics.place(e.span()) : "";
        Diagnostics.error(output, place + text(interpreter, job, lobby, e));
        explain(interpreter, files, lobby, e);
        Diagnostics.callersOfError(output, e.backtrace());
      }
      case StackOverflowError e -> exhausted(output, Problem.STACK_EXHAUSTED);
      case OutOfMemoryError e -> exhausted(output, Problem.MEMORY_EXHAUSTED);
      case ControlFlowException e -> {
        // A return or a break that had nothing to leave.
      }
      default -> Diagnostics.error(output, FailureLog.text(failure));
    }
  }

  private static void exhausted(Output output, Problem problem) {
    Diagnostics.error(output, problem.text());
    Diagnostics.explain(output, null, () -> Advice.of(problem.hint().orElse(null)));
  }

  /** Whether people know of its cause, and that it has others. */
  private static boolean isCounted(
      Interpreter interpreter, Job job, UrbiLobby lobby, UrbiException thrown) {
    boolean inTurn = lobby.hasShell() && lobby.shell().runs(job);
    if (!inTurn || lobby.output().errors() == ErrorStyle.PLAIN) {
      return false;
    }
    String missing = ErrorAdvice.missing(interpreter, lobby, thrown);
    return missing != null && lobby.failures().counts(missing, thrown.span());
  }

  private static void explain(
      Interpreter interpreter, LoadedFiles files, UrbiLobby lobby, UrbiException thrown) {
    Output output = lobby.output();
    if (output.errors() == ErrorStyle.PLAIN) {
      return;
    }
    SyntaxError wrong = thrown.syntaxError();
    String missing = ErrorAdvice.missing(interpreter, lobby, thrown);
    String cause = missing == null ? null : lobby.failures().causeOf(missing, thrown.span());
    if (wrong != null) {
      Diagnostics.explain(output, wrong.span(), () -> SyntaxAdvice.of(wrong));
    } else if (cause != null) {
      if (lobby.failures().isNews(cause)) {
        Diagnostics.explain(output, null, () -> Advice.of(cause));
      }
    } else {
      Diagnostics.explain(
          output, ownPlace(files, thrown), () -> ErrorAdvice.of(interpreter, lobby, thrown));
    }
    lobby.failures().add(thrown);
  }

  /** The line that people can do something about: within the library, the call that led there. */
  private static @Nullable Span ownPlace(LoadedFiles files, UrbiException thrown) {
    Span place = thrown.span();
    if (place == null || !files.isOfSystem(place)) {
      return place;
    }
    return thrown.backtrace().stream()
        .map(UrbiException.Call::span)
        .filter(call -> call != null && !files.isOfSystem(call))
        .findFirst()
        .orElse(place);
  }

  /**
   * Whether the error line starts with a location. A thrown value that is no Exception has none,
   * and some exceptions show their own.
   */
  private static boolean isPlaced(Interpreter interpreter, UrbiObject value) {
    return value.isA(interpreter.world().prototype("Exception"))
        && !interpreter.errors().is(value, ProblemKind.SYNTAX)
        && !interpreter.errors().tellsPlace(value);
  }

  private static String text(
      Interpreter interpreter, Job job, UrbiLobby lobby, UrbiException exception) {
    Frame frame = Frame.top(interpreter, job, lobby, new FrameLayout());
    try {
      return interpreter.asString(frame, exception.value());
    } catch (UrbiException e) {
      return Problem.UNPRINTABLE.text();
    }
  }
}
