package org.urbi.kernel.variable;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobOwner;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.object.UrbiObject;

/**
 * A function of urbiscript as a hook, whose target is the variable. It runs for the lobby that has
 * installed it: in the job that writes or reads, or in one of its own if that job may do more,
 * which then neither waits for the function nor is ended with it.
 */
final class FunctionHook implements Hook {
  private final UrbiObject lobby;
  private final UrbiObject function;
  private @Nullable Job apart;
  private boolean again;

  FunctionHook(UrbiObject lobby, UrbiObject function) {
    this.lobby = lobby;
    this.function = function;
  }

  @Override
  public void run(Frame frame, UrbiUVar variable, Datum value) {
    Job job = frame.job();
    if (job == apart) {
      // As in the job of a writer: what it does to the variable does not call it again.
      return;
    }
    if (job.identity().isAbove(lobby)) {
      setApart(frame, variable);
    } else {
      job.identity().doFor(lobby, () -> frame.interpreter().call(frame, function, variable));
    }
  }

  /** Calls it in a job; once more for all that happens meanwhile. */
  private void setApart(Frame frame, UrbiUVar variable) {
    again = true;
    if (apart == null) {
      Job started =
          JobOwner.start(
              frame.job().scheduler(),
              lobby,
              "notify",
              job -> {
                Frame top = Frame.top(frame.interpreter(), job, lobby, new FrameLayout());
                while (again) {
                  again = false;
                  frame.interpreter().call(top, function, variable);
                }
              });
      apart = started;
      started.onEnd(() -> apart = null);
    }
  }
}
