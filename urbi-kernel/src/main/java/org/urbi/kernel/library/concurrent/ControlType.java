package org.urbi.kernel.library.concurrent;

import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.event.Condition;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.event.Persistence;
import org.urbi.kernel.event.WaitUntil;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.ForkedCode;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.LoopJobs;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Control of the flow of execution (manual, "Control"). */
@UrbiType(
    value = "Control",
    doc = "Ways to control the flow of execution.",
    needs = Permission.NOTHING)
public final class ControlType {
  private ControlType() {}

  @Builtin(
      lazy = true,
      min = 1,
      max = 1,
      doc = "Evaluates its argument in a job of its own, under the current tags.")
  static UrbiObject detach(Frame frame, CallSite site, UrbiObject self) {
    return JobType.object(
        frame, start(frame, how(site), LoopJobs.scope(frame), code(site)::execute));
  }

  @Builtin(
      lazy = true,
      min = 1,
      max = 1,
      doc = "Evaluates its argument in a job of its own, under no tag.")
  static UrbiObject disown(Frame frame, CallSite site, UrbiObject self) {
    return JobType.object(frame, startUntagged(frame, how(site), code(site)::execute));
  }

  private static Node code(CallSite site) {
    return site.argumentNodes()[0];
  }

  private static CallSite how(CallSite site) {
    Node code = code(site);
    return new Started(site.calledName(), code.isWritten() ? code.span() : null);
  }

  /** How a job was started, for its backtrace. */
  private record Started(String calledName, @Nullable Span calledSpan) implements CallSite {}

  @Builtin(
      value = {"waituntil"},
      lazy = true,
      min = 1,
      max = 1,
      doc = "Waits until an expression is true, as the construct of that name does.")
  static void waitUntil(Frame frame, CallSite site, UrbiObject self) {
    Node condition = site.argumentNodes()[0];
    new WaitUntil(condition.span(), new Condition.WhenTrue(condition), null).execute(frame);
  }

  /** Starts a job that runs with the variables of a frame and outlives it. */
  public static Job start(Frame frame, TagScope scope, Consumer<Frame> action) {
    return start(frame, null, scope, action);
  }

  /** Starts such a job under no tag: it may outlive the connection. */
  public static Job startUntagged(Frame frame, Consumer<Frame> action) {
    return startUntagged(frame, null, action);
  }

  private static Job startUntagged(Frame frame, @Nullable CallSite how, Consumer<Frame> action) {
    Job starter = frame.job();
    if (!(starter.lobby() instanceof UrbiLobby lobby)) {
      return start(frame, how, starter.scheduler().rootScope(), action);
    }
    TagScope scope = lobby.detachedScope(starter);
    try {
      return start(frame, how, scope, action);
    } finally {
      scope.end();
    }
  }

  private static Job start(
      Frame frame, @Nullable CallSite how, TagScope scope, Consumer<Frame> action) {
    var body = new ForkedCode(action);
    Job job = frame.job().scheduler().startAhead(frame.job().lobby(), scope, "shell", body);
    if (how != null) {
      frame.shareLocals();
    }
    body.runWith(how == null ? frame.fork(job, false) : frame.detach(job, how));
    return job;
  }

  @Builtin(
      lazy = true,
      min = 2,
      max = 2,
      doc = "An object whose slot val says whether the expression has been true for that long.")
  static UrbiObject persist(Frame frame, CallSite site, UrbiObject self) {
    UrbiObject made = frame.interpreter().values().object.cloned();
    made.addSlot(
        frame.interpreter().world().symbol("val"), frame.interpreter().values().falseObject);
    Node[] arguments = site.argumentNodes();
    UrbiObject delay = arguments[1].execute(frame);
    double seconds = Arguments.number(frame, site, 2, delay);
    Persistence.watch(frame, arguments[0], Durations.nanoseconds(seconds), made);
    return made;
  }
}
