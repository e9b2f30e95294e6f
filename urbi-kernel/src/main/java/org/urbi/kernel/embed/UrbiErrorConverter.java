package org.urbi.kernel.embed;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.ProblemKind;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.lang.source.Location;

/** Converts what the kernel's code throws to what Java callers catch; on the kernel thread. */
final class UrbiErrorConverter {
  private static final Pattern LOCATION =
      Pattern.compile("(?:(.*):)?(\\d{1,9})\\.(\\d{1,9})(?:-(?:(\\d{1,9})\\.)?(\\d{1,9}))?");

  private UrbiErrorConverter() {}

  /** The error for a throwable that no urbiscript code has caught. */
  static UrbiError of(Embedding embedding, Frame frame, Throwable failure) {
    return switch (failure) {
      case UrbiException e -> thrown(embedding, frame, e);
      case StackOverflowError e -> simple(Problem.STACK_EXHAUSTED, e);
      case OutOfMemoryError e -> simple(Problem.MEMORY_EXHAUSTED, e);
      default -> {
        FailureLog.internal("an evaluation", failure);
        yield simple(FailureLog.text(failure), failure);
      }
    };
  }

  static UrbiError simple(String message, @Nullable Throwable cause) {
    return simple(message, null, cause);
  }

  private static UrbiError simple(Problem problem, Throwable cause) {
    return simple(problem.text(), problem.hint().orElse(null), cause);
  }

  private static UrbiError simple(
      String message, @Nullable String hint, @Nullable Throwable cause) {
    UrbiError error = new UrbiError(message, null, List.of(), null, hint, null);
    error.initCause(cause);
    return error;
  }

  private static UrbiError thrown(Embedding embedding, Frame frame, UrbiException exception) {
    Location location = exception.span() == null ? null : exception.span().location();
    List<UrbiError.Call> calls = new ArrayList<>();
    for (UrbiException.Call call : exception.backtrace()) {
      if (call.name() != null) {
        calls.add(
            new UrbiError.Call(
                Utf8Text.toJava(call.name()), call.span() == null ? null : call.span().location()));
      }
    }
    boolean placed = location == null || frame.interpreter().errors().tellsPlace(exception.value());
    String message = (placed ? "" : location + ": ") + text(frame, exception);
    return new UrbiError(
        message,
        location == null ? placeOfSyntaxError(frame, exception.value()) : location,
        calls,
        JavaValues.toJava(embedding, exception.value()),
        exception.hint().orElse(null),
        exception);
  }

  private static String text(Frame frame, UrbiException exception) {
    try {
      return Utf8Text.toJava(frame.interpreter().asString(frame, exception.value()));
    } catch (UrbiException | StackOverflowError e) {
      return Problem.UNPRINTABLE.text();
    }
  }

  /**
   * Source that does not parse has no call that failed: its location is a slot of the exception.
   */
  private static @Nullable Location placeOfSyntaxError(Frame frame, UrbiObject value) {
    Interpreter interpreter = frame.interpreter();
    if (!interpreter.errors().is(value, ProblemKind.SYNTAX)
        || !(value.lookup(interpreter.world().symbol("loc")) instanceof UrbiString text)) {
      return null;
    }
    Matcher place = LOCATION.matcher(text.value());
    if (!place.matches()) {
      return null;
    }
    int line = Integer.parseInt(place.group(2));
    int column = Integer.parseInt(place.group(3));
    int endLine = place.group(4) == null ? line : Integer.parseInt(place.group(4));
    int last = place.group(5) == null ? column : Integer.parseInt(place.group(5));
    return new Location(place.group(1), line, column, endLine, last + 1);
  }
}
