package org.urbi.kernel.event;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;

/** Whether an expression has been true for some time (manual, "Control", {@code persist}). */
public final class Persistence implements ExpressionWatcher.Listener, TagScope.Attachment {
  private final Frame home;
  private final TagScope scope;
  private final UrbiObject lobby;
  private final UrbiObject shown;
  private final long hold;
  private final ExpressionWatcher watch;
  private Timers.@Nullable Timer timer;

  private Persistence(Frame home, Node expression, long hold, UrbiObject shown) {
    this.home = home;
    this.scope = home.job().scopeForNew();
    this.lobby = home.job().lobby();
    this.hold = hold;
    this.shown = shown;
    this.watch = new ExpressionWatcher(home, expression, this);
  }

  /**
   * Watches an expression under the tags of the surrounding code.
   *
   * @param hold for how many nanoseconds the expression must be true
   * @param shown the object whose slot {@code val} shows the result
   */
  public static void watch(Frame frame, Node expression, long hold, UrbiObject shown) {
    frame.shareLocals();
    Frame home = frame.fork(frame.job(), false);
    var persistence = new Persistence(home, expression, hold, shown);
    persistence.scope.add(persistence);
    persistence.watch.begin(frame.job());
  }

  @Override
  public void evaluated(UrbiObject value, Job evaluator) {
    if (!Truth.of(home.in(evaluator), value)) {
      cancel();
      set(evaluator, false);
    } else if (hold == 0) {
      set(evaluator, true);
    } else if (timer == null) {
      var scheduler = evaluator.scheduler();
      timer = scheduler.timers().add(scheduler.now() + hold, this::timeIsUp);
    }
  }

  private void timeIsUp() {
    if (!scope.isStopping()) {
      home.job().scheduler().startDetached(lobby, scope, "persist", job -> set(job, true));
    }
  }

  private void set(Job job, boolean holds) {
    Frame frame = home.in(job);
    UrbiObject value = frame.interpreter().values().bool(holds);
    job.identity()
        .doFor(lobby, () -> SlotUpdate.assign(frame, shown, shown.world().symbol("val"), value));
  }

  private void cancel() {
    if (timer != null) {
      timer.cancel();
      timer = null;
    }
  }

  @Override
  public void stopped(@Nullable TagScope by) {
    cancel();
    watch.close();
    scope.remove(this);
  }
}
