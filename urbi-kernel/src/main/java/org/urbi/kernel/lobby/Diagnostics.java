package org.urbi.kernel.lobby;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.lang.source.Span;

/**
 * The lines in which a lobby is told of errors and warnings: {@code !!! place: text}, and then from
 * where the code was called.
 */
public final class Diagnostics {
  private static final String MARK = "!!! ";

  private static final String ERROR = "error";

  private Diagnostics() {}

  /** Tells of an error. */
  public static void error(Output output, String text) {
    output.send(ERROR, marked(text));
  }

  /** Tells of a warning; it is the caller who asks whether warnings are off. */
  public static void warning(Output output, String text) {
    output.send(WarningChannel.NAME, marked(text));
  }

  /** Tells from where the code with an error was called. */
  public static void callersOfError(Output output, List<UrbiException.Call> calls) {
    callers(output, ERROR, calls);
  }

  /** Tells from where the code with a warning was called. */
  public static void callersOfWarning(Output output, List<UrbiException.Call> calls) {
    callers(output, WarningChannel.NAME, calls);
  }

  private static void callers(Output output, String channel, List<UrbiException.Call> calls) {
    for (UrbiException.Call call : calls) {
      if (call.name() != null) {
        output.send(channel, marked(Problem.CALLED_FROM.text(place(call.span()), call.name())));
      }
    }
  }

  /** A line as it is shown. */
  public static String marked(String text) {
    return MARK + text;
  }

  /** A place as it stands before a text; empty when it is not known. */
  public static String place(@Nullable Span span) {
    return span == null ? "" : span.location() + ": ";
  }
}
