package org.urbi.kernel.event;

import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Loops;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.ast.Ast.Flavor;
import org.urbi.lang.source.Span;

/**
 * {@code every (period) body}: an endless loop whose turns begin at equal intervals. The turns of
 * the default flavor may overlap, those of {@code every|} wait for one another.
 */
public final class Every extends Node {
  private final Flavor flavor;
  private final Node period;
  private final Node body;

  public Every(Span span, Flavor flavor, Node period, Node body) {
    super(span);
    this.flavor = flavor;
    this.period = period;
    this.body = body;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    var pause = new Pause();
    Node loop =
        flavor == Flavor.PIPE || flavor == Flavor.SEMICOLON
            ? new Loops.Sequential(span(), Flavor.PIPE, null, pause, null, body)
            : new Loops.Concurrent(span(), null, pause, null, body);
    return loop.execute(frame);
  }

  /** Waits for the next turn, as the condition of a loop which is always true. */
  private final class Pause extends Node {
    private long due = -1;

    Pause() {
      super(Every.this.span());
    }

    @Override
    public UrbiObject execute(Frame frame) {
      return frame.interpreter().values().bool(test(frame));
    }

    @Override
    public boolean test(Frame frame) {
      Job job = frame.job();
      long interval = Durations.positive(frame, period, "every");
      if (due < 0) {
        due = now(job) + interval;
        return true;
      }
      if (due > now(job)) {
        job.sleepUntil(due + job.timeShift());
      } else {
        job.yieldNow();
      }
      // A turn that is late moves the ones after it.
      due = Math.max(due, now(job)) + interval;
      return true;
    }

    /** The time that the job has not been frozen. */
    private long now(Job job) {
      return job.scheduler().now() - job.timeShift();
    }
  }
}
