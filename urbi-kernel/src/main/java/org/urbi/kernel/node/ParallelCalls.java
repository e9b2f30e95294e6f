package org.urbi.kernel.node;

import java.util.List;
import org.urbi.kernel.job.JobGroup;
import org.urbi.kernel.object.UrbiObject;

/** Runs an action of a library function on many values at once, each in a job of its own. */
public final class ParallelCalls {
  /** The action for one value. */
  @FunctionalInterface
  public interface Action {
    /** Runs the action in the job of that frame. */
    void run(Frame frame, UrbiObject value);
  }

  private ParallelCalls() {}

  /** Starts as many jobs as there are values, in their order, and waits for all of them. */
  public static void forEach(Frame caller, List<UrbiObject> values, Action action) {
    JobGroup group = new JobGroup(caller.job());
    try {
      for (UrbiObject value : values) {
        var branch = new ForkedCode(frame -> action.run(frame, value));
        branch.runWith(caller.fork(group.start(branch), true));
      }
      group.join();
    } catch (RuntimeException e) {
      throw group.translate(e);
    } finally {
      group.leave();
    }
  }
}
