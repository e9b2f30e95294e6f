package org.urbi.kernel.library.lobby;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.WarningChannel;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.lang.parse.SyntaxWarning;
import org.urbi.lang.source.Span;

/** Messages on the channel {@code warning} (manual, "Channel", {@code warning}). */
public final class Warnings {
  private Warnings() {}

  /**
   * Warns that the function called at that site is deprecated: {@code `old' is deprecated, use
   * `other'}.
   *
   * @param other the replacement, or null
   */
  public static void deprecated(Frame caller, CallSite site, String old, @Nullable String other) {
    if (!isOff(caller)) {
      Output output = LobbyType.output(caller);
      Diagnostics.warning(output, Diagnostics.place(site.calledSpan()) + deprecation(old, other));
      Diagnostics.callersOfWarning(output, caller.backtrace());
    }
  }

  /** Something is deprecated, wherever it is called. */
  public static void deprecated(Frame caller, String old, String other) {
    if (!isOff(caller)) {
      Diagnostics.warning(LobbyType.output(caller), deprecation(old, other));
    }
  }

  private static String deprecation(String old, @Nullable String other) {
    return other == null ? Problem.DEPRECATED.text(old) : Problem.DEPRECATED_FOR.text(old, other);
  }

  /** Something that the function called at that site, null for Java code, did not like. */
  public static void inside(Frame caller, CallSite site, Problem problem, Object... places) {
    if (!isOff(caller)) {
      tell(caller, site, null, problem.text(places));
    }
  }

  /** Something in a text that is evaluated by the function called at that site. */
  public static void in(Frame caller, @Nullable CallSite site, SyntaxWarning warning) {
    if (!isOff(caller)) {
      tell(caller, site, warning.span(), warning.message());
    }
  }

  private static void tell(
      Frame caller, @Nullable CallSite site, @Nullable Span span, String text) {
    Output output = LobbyType.output(caller);
    Diagnostics.warning(output, Diagnostics.place(span) + text);
    if (site != null) {
      Diagnostics.callersOfWarning(
          output, List.of(new UrbiException.Call(site.calledName(), site.calledSpan())));
    }
    Diagnostics.callersOfWarning(output, caller.backtrace());
  }

  private static boolean isOff(Frame caller) {
    return WarningChannel.isOff(caller.interpreter().world());
  }
}
