package org.urbi.kernel.node;

import java.util.List;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobGroup;
import org.urbi.kernel.object.UrbiObject;

/** How library functions do something with many values at once, each in a job of its own. */
public final class ParallelCalls {
  /** What is done with one value. */
  @FunctionalInterface
  public interface Action {
    /** Does it in the job of that frame. */
    void run(Frame frame, UrbiObject value);
  }

  private ParallelCalls() {}

  /** Starts as many jobs as there are values, in their order, and waits for all of them. */
  public static void forEach(Frame caller, List<UrbiObject> values, Action action) {
    JobGroup group = new JobGroup(caller.job());
    try {
      for (UrbiObject value : values) {
        Branch branch = new Branch(action, value);
        branch.frame = caller.fork(group.start(branch), true);
      }
      group.join();
    } catch (RuntimeException e) {
      throw group.translate(e);
    } finally {
      group.leave();
    }
  }

  /** One of the jobs. */
  private static final class Branch implements Job.Body {
    private final Action action;
    private final UrbiObject value;
    private Frame frame;

    Branch(Action action, UrbiObject value) {
      this.action = action;
      this.value = value;
    }

    @Override
    public void run(Job job) {
      action.run(frame, value);
    }
  }
}
