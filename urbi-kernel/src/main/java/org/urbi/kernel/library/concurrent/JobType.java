package org.urbi.kernel.library.concurrent;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobLocal;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.library.code.StackFrames;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.tag.UrbiTag;

/** Light threads (manual, "Job"). */
@UrbiType(
    value = "Job",
    protos = {"Object", "Traceable"},
    doc = "A light thread of execution.",
    needs = Permission.NOTHING)
public final class JobType {
  /** The objects that show the jobs; made when asked for. */
  private static final JobLocal<UrbiObject> SHOWN = new JobLocal<>();

  private final StackFrames stackFrames;

  JobType(StackFrames stackFrames) {
    this.stackFrames = stackFrames;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiJob(world.values().object.cloneShape(), null);
  }

  /** The object that shows a job. */
  public static UrbiObject object(Frame frame, Job job) {
    UrbiObject shown = SHOWN.get(job);
    if (shown == null) {
      UrbiObject prototype = frame.interpreter().world().prototype("Job");
      shown = new UrbiJob(prototype.cloneShape(), job);
      SHOWN.set(job, shown);
    }
    return shown;
  }

  @Builtin(doc = "The job that asks.")
  public static UrbiObject current(Frame frame, UrbiObject self) {
    return object(frame, frame.job());
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

  @Builtin(doc = "The tags under which it runs, outermost first.")
  static List<UrbiObject> tags(UrbiJob self) {
    if (self.job() == null) {
      return List.of();
    }
    List<UrbiObject> tags = new ArrayList<>();
    for (TagState state : self.job().scope().tags()) {
      if (state.owner() != null && isKnown(state.owner())) {
        tags.addFirst(state.owner());
      }
    }
    return tags;
  }

  /** Tags without a name belong to constructs of the language. */
  private static boolean isKnown(UrbiObject tag) {
    return tag.getClass() != UrbiTag.class || tag.lookup(tag.world().symbol("name")) != null;
  }

  @Builtin(doc = "Ends the job.")
  static void terminate(Frame frame, CallSite site, UrbiJob self) {
    if (self.job() != null) {
      PermissionCheck.checkChange(frame, site.calledName(), self.job());
      self.job().terminate();
      if (self.job() == frame.job()) {
        frame.job().checkInjected();
      } else {
        waitForTermination(frame, site, self);
      }
    }
  }

  @Builtin(doc = "Waits until the job has ended.")
  static void waitForTermination(Frame frame, CallSite site, UrbiJob self) {
    Job waiting = frame.job();
    if (self.job() == null) {
      return;
    }
    boolean[] over = {false};
    Runnable end =
        () -> {
          over[0] = true;
          waiting.wake();
        };
    self.job().onEnd(end);
    try {
      while (!over[0]) {
        WaitingCall.note(frame, site);
        waiting.waitForWake(Wait.JOBS);
      }
    } finally {
      // Stopped before: a job that never ends would keep all that have ever waited for it.
      self.job().forgetOnEnd(end);
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

  @Builtin(
      value = {"clone", "new"},
      doc = "Not possible: a job cannot be copied.")
  static UrbiObject clone(Frame frame, CallSite site, UrbiObject self) {
    throw frame.error(site, Problem.JOB_NOT_CLONEABLE);
  }

  private static List<UrbiException.Call> calls(Frame frame, UrbiJob self) {
    if (self.job() == null) {
      return List.of();
    }
    return self.job() == frame.job() ? frame.backtrace() : WaitingCall.backtrace(self.job());
  }

  @Builtin(doc = "The calls that are going on in the job, innermost first.")
  UrbiObject backtrace(Frame frame, UrbiJob self) {
    return stackFrames.list(calls(frame, self));
  }

  @Builtin(doc = "Tells the state of the job: its status, its tags, its calls.")
  static void dumpState(Frame frame, UrbiJob self) {
    Output output = LobbyType.output(frame);
    output.send("", "*** Job: " + name(self));
    output.send("", "***   State: " + status(self));
    output.send("", "***   Tags:");
    for (UrbiObject tag : tags(self)) {
      output.send("", "***     " + frame.interpreter().asString(frame, tag));
    }
    output.send("", "***   Backtrace:");
    for (UrbiException.Call call : calls(frame, self)) {
      if (call.name() != null) {
        output.send(
            "",
            "***     " + (call.span() == null ? "" : call.span().location() + ": ") + call.name());
      }
    }
  }

  @Builtin(
      doc = "Says whether what this job does concerns the others; of no effect here.",
      needs = Permission.USER)
  static void setSideEffectFree(UrbiJob self, UrbiObject value) {
    // Jobs are run in a fixed order, whatever they do.
  }
}
