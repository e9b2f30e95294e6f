package org.urbi.kernel.lobby;

import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.lang.advice.Advice;
import org.urbi.lang.source.Span;

/**
 * Formats errors and warnings for a lobby: {@code !!! place: text}, then the calls that led there.
 */
public final class Diagnostics {
  private static final String MARK = "!!! ";

  private static final String ERROR = "error";

  private Diagnostics() {}

  /** Sends an error. */
  public static void error(Output output, String text) {
    output.send(ERROR, output.errors().problem(marked(text), true));
  }

  /** Sends a warning; the caller checks whether warnings are off. */
  public static void warning(Output output, String text) {
    output.send(WarningChannel.NAME, output.errors().problem(marked(text), false));
  }

  /**
   * Sends what people want to know beyond the message, if anybody looks at the output.
   *
   * @param place null when it is not known
   * @param advice asked for only then
   */
  public static void explain(Output output, @Nullable Span place, Supplier<Advice> advice) {
    if (output.errors() != ErrorStyle.PLAIN) {
      output.write(Explanation.of(output.errors(), place, advice.get()));
    }
  }

  /** Sends the calls that led to an error. */
  public static void callersOfError(Output output, List<UrbiException.Call> calls) {
    callers(output, ERROR, calls);
  }

  /** Sends the calls that led to a warning. */
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

  /** A line with the mark of errors and warnings. */
  public static String marked(String text) {
    return MARK + text;
  }

  /** A location as the prefix of a text; empty if it is not known. */
  public static String place(@Nullable Span span) {
    return span == null ? "" : span.location() + ": ";
  }
}
