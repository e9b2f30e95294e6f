package org.urbi.kernel.library.concurrent;

import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobLocal;
import org.urbi.kernel.job.JobState;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;

/**
 * The call in which a job waits, kept for its backtrace.
 *
 * @param caller the frame of the caller
 */
public record WaitingCall(CallSite site, Frame caller) {
  private static final JobLocal<WaitingCall> LATEST = new JobLocal<>();

  /** Notes that the running job is about to wait in a function called at that site. */
  public static void note(Frame caller, CallSite site) {
    LATEST.set(caller.job(), new WaitingCall(site, caller));
    caller.job().at(caller, site::calledSpan);
  }

  /** The calls that are going on in a job, innermost first. */
  static List<UrbiException.Call> backtrace(Job job) {
    List<UrbiException.Call> calls = new ArrayList<>();
    if (LATEST.get(job) instanceof WaitingCall waiting && job.state() != JobState.ENDED) {
      calls.add(new UrbiException.Call(waiting.site.calledName(), waiting.site.calledSpan()));
      calls.addAll(waiting.caller.backtrace());
    }
    return calls;
  }
}
