package org.urbi.kernel.library.lobby;

import java.util.List;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.WarningChannel;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.lang.source.Span;

/** Messages on the channel {@code warning} (manual, "Channel", {@code warning}). */
public final class Warnings {
  private static final String CHANNEL = WarningChannel.NAME;

  private Warnings() {}

  /** What is called at that site is deprecated: {@code `old' is deprecated, use `other'}. */
  public static void deprecated(Frame caller, CallSite site, String old, String other) {
    if (WarningChannel.isOff(caller.interpreter().world())) {
      return;
    }
    Span span = site.calledSpan();
    Output output = LobbyType.of(caller).output();
    output.send(
        CHANNEL,
        "!!! "
            + place(span)
            + "`"
            + old
            + "' is deprecated"
            + (other == null ? "" : ", use `" + other + "'"));
    callers(output, caller.backtrace());
  }

  /** Something is deprecated, wherever it is called. */
  public static void deprecated(Frame caller, String old, String other) {
    if (!WarningChannel.isOff(caller.interpreter().world())) {
      LobbyType.of(caller)
          .output()
          .send(CHANNEL, "!!! `" + old + "' is deprecated, use `" + other + "'");
    }
  }

  /** Something that the function called at that site, null for Java code, did not like. */
  public static void inside(Frame caller, CallSite site, String message) {
    if (WarningChannel.isOff(caller.interpreter().world())) {
      return;
    }
    Output output = LobbyType.of(caller).output();
    output.send(CHANNEL, "!!! " + message);
    if (site != null) {
      callers(output, List.of(new UrbiException.Call(site.calledName(), site.calledSpan())));
    }
    callers(output, caller.backtrace());
  }

  /** Something in a text that is evaluated by the function called at that site. */
  public static void at(Frame caller, CallSite site, Span span, String message) {
    if (WarningChannel.isOff(caller.interpreter().world())) {
      return;
    }
    Output output = LobbyType.of(caller).output();
    output.send(CHANNEL, "!!! " + place(span) + message);
    if (site != null) {
      callers(output, List.of(new UrbiException.Call(site.calledName(), site.calledSpan())));
    }
    callers(output, caller.backtrace());
  }

  private static void callers(Output output, List<UrbiException.Call> calls) {
    for (UrbiException.Call call : calls) {
      if (call.name() != null) {
        output.send(CHANNEL, "!!!    called from: " + place(call.span()) + call.name());
      }
    }
  }

  private static String place(Span span) {
    return span == null ? "" : span.location() + ": ";
  }
}
