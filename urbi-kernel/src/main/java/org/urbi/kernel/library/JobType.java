package org.urbi.kernel.library;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Light threads (manual, "Job"). */
@UrbiType(
    value = "Job",
    protos = {"Object"},
    doc = "A light thread of execution.")
final class JobType {
  private JobType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiJob(world.values().object.cloneShape(), null);
  }

  /** The object that shows a job. */
  static UrbiObject object(Frame frame, Job job) {
    if (job.object == null) {
      UrbiObject prototype = frame.interpreter().world().prototype("Job");
      job.object = new UrbiJob(prototype.cloneShape(), job);
    }
    return job.object;
  }

  @Builtin(doc = "The job itself.")
  static UrbiObject asJob(UrbiJob self) {
    return self;
  }

  @Builtin(doc = "The job as text: Job<name>.")
  static String asString(UrbiJob self) {
    return self.job() == null ? "Job" : "Job<" + self.job().name() + ">";
  }

  @Builtin(doc = "The name of the job.")
  static String name(UrbiJob self) {
    return self.job() == null ? "Job" : self.job().name();
  }

  @Builtin(doc = "Whether it runs, sleeps, waits or has ended, and whether it is frozen.")
  static String status(UrbiJob self) {
    Job job = self.job();
    if (job == null) {
      return "";
    }
    return job.state().text() + (job.isFrozen() ? " (frozen)" : "");
  }

  @Builtin(doc = "The tags under which it runs, innermost first.")
  static List<UrbiObject> tags(UrbiJob self) {
    return self.job() == null
        ? List.of()
        : self.job().scope().tags().stream()
            .map(state -> (UrbiObject) state.owner())
            .filter(tag -> tag != null)
            .toList();
  }

  @Builtin(doc = "Ends the job.")
  static void terminate(Frame frame, UrbiJob self) {
    if (self.job() != null) {
      self.job().terminate();
      if (self.job() == frame.job()) {
        frame.job().checkInjected();
      } else {
        waitForTermination(frame, self);
      }
    }
  }

  @Builtin(doc = "Waits until the job has ended.")
  static void waitForTermination(Frame frame, UrbiJob self) {
    Job waiting = frame.job();
    if (self.job() == null) {
      return;
    }
    boolean[] over = {false};
    self.job()
        .onEnd(() -> {
          over[0] = true;
          waiting.wake();
        });
    while (!over[0]) {
      waiting.waitForWake();
    }
  }

  @Builtin(doc = "Lets the other jobs run.")
  static void waitForChanges(Frame frame, UrbiObject self) {
    frame.job().yieldNow();
  }

  @Builtin(doc = "How many seconds it has been frozen in all.")
  static double timeShift(UrbiJob self) {
    return self.job() == null ? 0 : Durations.seconds(self.job().timeShift());
  }
}
