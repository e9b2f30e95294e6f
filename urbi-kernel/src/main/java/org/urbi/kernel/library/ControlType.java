package org.urbi.kernel.library;

import java.util.function.Consumer;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.UrbiObject;

/** Control of the flow of execution (manual, "Control"). */
@UrbiType(value = "Control", doc = "Ways to control the flow of execution.")
final class ControlType {
  private ControlType() {}

  @Builtin(
      lazy = true,
      min = 1,
      max = 1,
      doc = "Evaluates its argument in a job of its own, under the current tags.")
  static UrbiObject detach(Frame frame, CallSite site, UrbiObject self) {
    return background(frame, site, frame.job().scope());
  }

  @Builtin(
      lazy = true,
      min = 1,
      max = 1,
      doc = "Evaluates its argument in a job of its own, under no tag.")
  static UrbiObject disown(Frame frame, CallSite site, UrbiObject self) {
    return background(frame, site, frame.job().scheduler().rootScope());
  }

  private static UrbiObject background(Frame frame, CallSite site, TagScope scope) {
    Node code = site.argumentNodes()[0];
    return JobType.object(frame, start(frame, scope, code::execute));
  }

  /** Starts a job that runs with the variables of a frame and outlives it. */
  static Job start(Frame frame, TagScope scope, Consumer<Frame> action) {
    var body =
        new Job.Body() {
          Frame forked;

          @Override
          public void run(Job job) {
            action.accept(forked);
          }
        };
    Job job = frame.job().scheduler().startDetached(frame.job().lobby(), scope, "shell", body);
    body.forked = frame.fork(job, false);
    return job;
  }
}
