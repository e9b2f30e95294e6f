package org.urbi.kernel.event;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
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
    boolean overlapping = flavor != Flavor.PIPE && flavor != Flavor.SEMICOLON;
    var pause = new Pause(overlapping, frame.job());
    Node loop =
        overlapping
            ? new Loops.Concurrent(span(), null, pause, null, body)
            : new Loops.Sequential(span(), Flavor.PIPE, null, pause, null, body);
    pause.scope.add(pause);
    try {
      return loop.execute(frame);
    } finally {
      pause.scope.remove(pause);
    }
  }

  /**
   * Waits for the next turn, as the condition of a loop which is always true. Turns are due at the
   * multiples of the period: a turn that starts late, because the machine was busy, does not delay
   * the next ones. Only if turns wait for one another, and one lasted longer than the period, the
   * next period starts at its end.
   */
  private final class Pause extends Node implements Reaction {
    private final boolean overlapping;
    private final TagScope scope;
    private final UrbiObject lobby;
    private final Occurrences occurrences = new Occurrences();
    private long due = -1;
    private long begun;

    Pause(boolean overlapping, Job job) {
      super(Every.this.span());
      this.overlapping = overlapping;
      this.scope = job.scope();
      this.lobby = job.lobby();
    }

    @Override
    public UrbiObject execute(Frame frame) {
      return frame.interpreter().values().bool(test(frame));
    }

    @Override
    public boolean test(Frame frame) {
      Job job = frame.job();
      long interval = Durations.nanoseconds(frame, period);
      if (due < 0) {
        due = now(job);
      } else {
        if (!overlapping && now(job) - begun > interval) {
          due = now(job);
        }
        if (due > now(job)) {
          job.at(frame, this).sleepUntil(due + job.timeShift());
        } else if (!overlapping) {
          job.at(frame, this).yieldNow();
        }
      }
      begun = now(job);
      occurrences.note(job.scheduler().now());
      due += interval;
      return true;
    }

    @Override
    public Facts facts() {
      return new Facts("every", span(), scope, lobby, occurrences, null);
    }

    /** The job of the loop is stopped, too, and ends it. */
    @Override
    public void stopped(@Nullable TagScope by) {}

    /** The time, without the time during which the job was frozen. */
    private long now(Job job) {
      return job.scheduler().now() - job.timeShift();
    }
  }
}
