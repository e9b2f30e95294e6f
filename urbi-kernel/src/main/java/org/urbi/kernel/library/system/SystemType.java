package org.urbi.kernel.library.system;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.library.concurrent.ControlType;
import org.urbi.kernel.library.concurrent.JobType;
import org.urbi.kernel.library.concurrent.WaitingCall;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.LoopJobs;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;

/** The server (manual, "System"). */
@UrbiType(value = "System", doc = "The server on which the code runs.", needs = Permission.NOTHING)
final class SystemType {
  private final ShutdownControl kernelEnd;

  SystemType(ShutdownControl kernelEnd) {
    this.kernelEnd = kernelEnd;
  }

  @Builtin(doc = "Waits for that many seconds; for ever when none is given.")
  static void sleep(
      Frame frame, CallSite site, UrbiObject self, @Optional @Nullable Double duration) {
    Job job = frame.job();
    WaitingCall.note(frame, site);
    if (duration == null || duration == Double.POSITIVE_INFINITY) {
      job.waitForWake(Wait.TIME);
      return;
    }
    // A deadline in the past is due now.
    job.sleepUntil(job.scheduler().deadline(Durations.nanoseconds(duration)));
  }

  @Builtin(doc = "The number of seconds since the server was started.")
  static double time(Frame frame, UrbiObject self) {
    return Durations.seconds(frame.job().scheduler().measure());
  }

  @Builtin(doc = "The time, less what this code has spent frozen.")
  static double shiftedTime(Frame frame, UrbiObject self) {
    return time(frame, self) - Durations.seconds(frame.job().timeShift());
  }

  @Builtin(doc = "The number of ticks since the server was started.")
  static double cycle(Frame frame, UrbiObject self) {
    return frame.job().scheduler().time().cycle();
  }

  @Builtin(doc = "Ends the server.", needs = Permission.OWNER)
  void shutdown(Frame frame, UrbiObject self, @Optional @Nullable Integer status) {
    kernelEnd.requestShutdown(status == null ? 0 : status);
    frame.job().waitForWake();
  }

  @Builtin(doc = "Evaluates source text on the target, and returns its value.")
  static UrbiObject eval(
      Frame frame,
      CallSite site,
      UrbiObject self,
      String source,
      @Optional @Nullable UrbiObject target) {
    return Evaluation.eval(frame, site, target == null ? self : target, source, null);
  }

  @Builtin(doc = "The jobs that have not ended.")
  static List<UrbiObject> jobs(Frame frame, UrbiObject self) {
    List<UrbiObject> jobs = new ArrayList<>();
    for (Job job : frame.job().scheduler().jobs()) {
      jobs.add(JobType.object(frame, job));
    }
    return jobs;
  }

  @Builtin(doc = "The number of jobs that have not ended.")
  static double aliveJobs(Frame frame, UrbiObject self) {
    return frame.job().scheduler().jobs().size();
  }

  @Builtin(doc = "Calls a function in a job of its own; under no tag if so asked.")
  static UrbiObject spawn(
      Frame frame, CallSite site, UrbiObject self, UrbiObject code, UrbiObject detached) {
    Consumer<Frame> action = forked -> frame.interpreter().call(forked, site, code, self);
    Job job =
        Truth.of(frame, detached)
            ? ControlType.startUntagged(frame, action)
            : ControlType.start(frame, LoopJobs.scope(frame), action);
    return JobType.object(frame, job);
  }

  @Builtin(doc = "Throws the message unless the value is true.")
  static void assert_(Frame frame, UrbiObject self, UrbiObject value, String message) {
    if (!Truth.of(frame, value)) {
      throw frame.interpreter().errors().of(Problem.ASSERTION_FAILED, message).build();
    }
  }

  @Builtin(
      doc =
          "Refuses an argument of the function that asks, unless it is of that type: an error where"
              + " the function was called.")
  static void expectArgument(
      Frame frame, CallSite site, UrbiObject self, int index, UrbiObject value, UrbiObject type) {
    if (!value.isA(type)) {
      String called = frame.calledAs();
      throw frame.locatedAtCall(
          frame
              .interpreter()
              .errors()
              .argumentType(called == null ? site.calledName() : called, index, value, type));
    }
  }

  @Builtin(doc = "Whether assertions are not checked.")
  static boolean ndebug(Frame frame, UrbiObject self) {
    return frame.interpreter().assertionsDisabled();
  }

  @Builtin(
      value = "ndebug",
      setter = true,
      doc = "Sets whether assertions are not checked.",
      needs = Permission.OWNER)
  static void setNdebug(Frame frame, UrbiObject self, UrbiObject value) {
    frame.interpreter().disableAssertions(Truth.of(frame, value));
  }

  @Builtin(doc = "Whether the message of a failed assertion shows the values of its parts.")
  static boolean assertVerbose(Frame frame, UrbiObject self) {
    return frame.interpreter().assertionsShowValues();
  }

  @Builtin(
      value = "assertVerbose",
      setter = true,
      doc = "Sets whether it shows the values.",
      needs = Permission.OWNER)
  static void setAssertVerbose(Frame frame, UrbiObject self, UrbiObject value) {
    frame.interpreter().showValuesOfAssertions(Truth.of(frame, value));
  }
}
