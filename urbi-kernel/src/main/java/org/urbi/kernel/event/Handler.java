package org.urbi.kernel.event;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.node.ForkedCode;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Profiler;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * Executes the clauses of an {@code at}: the body when its condition starts to hold, {@code
 * onleave} when it stops holding. They run in jobs of their own under the tags of the {@code at}; a
 * synchronous {@code at} runs them at once in the job that triggered it.
 */
final class Handler {
  /** How deeply synchronous handlers may be nested. */
  private static final int MAXIMUM_NESTED = 10_000;

  private final Frame home;
  private final TagScope scope;

  /** The lobby that executed the {@code at}; its job may run for another lobby by now. */
  private final UrbiObject lobby;

  private final Node body;
  private final @Nullable Node onLeave;
  private final boolean sync;
  private final Occurrences occurrences = new Occurrences();

  /**
   * @param home the activation in which the {@code at} was executed
   * @param onLeave may be null
   */
  Handler(Frame home, Node body, @Nullable Node onLeave, boolean sync) {
    this.home = home;
    this.scope = home.job().scopeForNew();
    this.lobby = home.job().lobby();
    this.body = Profiler.observing(home.job(), "event", body);
    this.onLeave = onLeave == null ? null : Profiler.observing(home.job(), "event", onLeave);
    this.sync = sync;
  }

  Frame home() {
    return home;
  }

  UrbiObject lobby() {
    return lobby;
  }

  TagScope scope() {
    return scope;
  }

  /**
   * What is known of the {@code at}.
   *
   * @param event for which it waits; null if for a condition
   */
  Reaction.Facts facts(Span span, @Nullable UrbiEvent event) {
    return new Reaction.Facts("at", span, scope, lobby, occurrences, event);
  }

  boolean hasLeave() {
    return onLeave != null;
  }

  /** Executes the body, with the variables of that frame. */
  void enter(Frame frame, Job trigger, boolean wait) {
    occurrences.note(trigger.scheduler().now());
    run(frame, trigger, body, wait);
  }

  /** Executes the {@code onleave} clause, with the variables of that frame. */
  void leave(Frame frame, Job trigger, boolean wait) {
    if (onLeave != null) {
      run(frame, trigger, onLeave, wait);
    }
  }

  /**
   * Executes the {@code onleave} clause because the {@code at} has been stopped; it runs outside of
   * the tag that was stopped.
   *
   * @param by the scope that was stopped; null if the clause must not be executed
   */
  void leaveStopped(Frame frame, @Nullable TagScope by) {
    if (onLeave != null && by != null) {
      var detached = new ForkedCode(onLeave::execute);
      Job job = home.job().scheduler().startDetached(lobby, by.parent(), "at", detached);
      detached.runWith(frame.fork(job, false));
    }
  }

  private void run(Frame frame, Job trigger, Node code, boolean wait) {
    if (sync || wait) {
      if (!trigger.beginSend(MAXIMUM_NESTED)) {
        throw frame.interpreter().errors().scheduling(Problem.STACK_EXHAUSTED);
      }
      try {
        trigger.identity().doFor(lobby, () -> code.execute(frame.fork(trigger, false)));
      } finally {
        trigger.endSend();
      }
      return;
    }
    var detached = new ForkedCode(code::execute);
    Job job = trigger.scheduler().startDetached(lobby, scope, "at", detached);
    detached.runWith(frame.fork(job, false));
  }

  /** Does something later, unless it is cancelled. */
  Timers.Timer later(Job trigger, long nanoseconds, Job.Body action) {
    var scheduler = trigger.scheduler();
    return scheduler
        .timers()
        .add(
            scheduler.now() + nanoseconds,
            () -> {
              if (!scope.isStopping()) {
                scheduler.startDetached(lobby, scope, "at", action);
              }
            });
  }
}
