package org.urbi.kernel.library.concurrent;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Located;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.lang.source.Span;

/**
 * The call in which a job waits, kept for its backtrace.
 *
 * @param caller the frame of the caller
 */
public record WaitingCall(CallSite site, Frame caller) implements Located {
  /** Notes that the running job is about to wait in a function called at that site. */
  public static void note(Frame caller, CallSite site) {
    caller.job().at(caller, new WaitingCall(site, caller));
  }

  @Override
  public @Nullable Span span() {
    return site.calledSpan();
  }

  /** The calls that are going on in a job, innermost first. */
  static List<UrbiException.Call> backtrace(Job job) {
    List<UrbiException.Call> calls = new ArrayList<>();
    if (job.where() instanceof WaitingCall waiting) {
      calls.add(new UrbiException.Call(waiting.site.calledName(), waiting.site.calledSpan()));
      calls.addAll(waiting.caller.backtrace());
    }
    return calls;
  }
}
