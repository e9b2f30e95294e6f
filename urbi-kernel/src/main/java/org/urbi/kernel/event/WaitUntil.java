package org.urbi.kernel.event;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * {@code waituntil (condition)}: suspends the job until an expression is true, or an event is
 * emitted.
 */
public final class WaitUntil extends Node {
  private final Condition condition;
  private final @Nullable Node duration;

  /**
   * @param duration how long it must hold, or null
   */
  public WaitUntil(Span span, Condition condition, @Nullable Node duration) {
    super(span);
    this.condition = condition;
    this.duration = duration;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    long hold = Durations.nanoseconds(frame, duration);
    if (condition instanceof Condition.WhenEmitted emitted) {
      await(frame, emitted, hold);
    } else {
      await(frame, (Condition.WhenTrue) condition, hold);
    }
    return frame.interpreter().values().voidObject;
  }

  private void await(Frame frame, Condition.WhenEmitted condition, long hold) {
    UrbiEvent source = EventLookup.event(frame, condition.event());
    var waiting = new Waiting(frame, Wait.EVENT, hold);
    var subscription = new ForEvent(waiting, condition.filter());
    source.subscribe(subscription, frame.job());
    try {
      waiting.await(this);
    } catch (UrbiException e) {
      throw frame.located(e, condition.event().span());
    } finally {
      source.unsubscribe(subscription);
      waiting.holdsNoMore();
    }
  }

  private void await(Frame frame, Condition.WhenTrue condition, long hold) {
    var waiting = new Waiting(frame, Wait.CONDITION, hold);
    var watch = new ExpressionWatcher(frame, condition.expression(), new ForExpression(waiting));
    try {
      watch.begin(frame.job());
      waiting.await(this);
    } catch (UrbiException e) {
      throw frame.located(e, condition.expression().span());
    } finally {
      watch.close();
      waiting.holdsNoMore();
    }
  }

  /**
   * A job that waits. There is but one class of them: where two extend it, the JVM gives up the
   * code of all that wait when it loads the second one.
   */
  private static final class Waiting {
    private final Frame frame;
    private final Job job;
    private final Wait what;
    private final long hold;
    private Timers.@Nullable Timer timer;
    private boolean done;

    Waiting(Frame frame, Wait what, long hold) {
      this.frame = frame;
      this.what = what;
      this.job = frame.job();
      this.hold = hold;
    }

    boolean mustHold() {
      return hold > 0;
    }

    void holds() {
      if (!mustHold()) {
        release();
      } else if (timer == null) {
        var scheduler = job.scheduler();
        timer = scheduler.timers().add(scheduler.now() + hold, this::release);
      }
    }

    void holdsNoMore() {
      if (timer != null) {
        timer.cancel();
        timer = null;
      }
    }

    private void release() {
      done = true;
      job.wake();
    }

    void await(Node place) {
      if (done) {
        return;
      }
      // Asked behind the wait, as in a chain of statements.
      do {
        job.at(frame, place).waitForWake(what);
      } while (!done);
    }
  }

  /** Waits for an expression to be true. */
  private record ForExpression(Waiting waiting) implements ExpressionWatcher.Listener {
    @Override
    public void evaluated(UrbiObject value, Job evaluator) {
      if (Truth.of(waiting.frame.in(evaluator), value)) {
        waiting.holds();
      } else {
        waiting.holdsNoMore();
      }
    }
  }

  /** Waits for an event. */
  static final class ForEvent implements Subscription, EmissionNote {
    private final Waiting waiting;
    private final EventFilter filter;
    private final UrbiObject lobby;

    ForEvent(Waiting waiting, EventFilter filter) {
      this.waiting = waiting;
      this.filter = filter;
      this.lobby = waiting.job.lobby();
    }

    @Override
    public void begin(Emission emission, Job emitter) {
      // The pattern binds variables of the waiting code; only the first matching event binds them.
      if (!waiting.done && !waiting.job.isFrozen() && accepts(emission, emitter)) {
        if (waiting.mustHold()) {
          emission.note(this, this);
        }
        waiting.holds();
      }
    }

    private boolean accepts(Emission emission, Job emitter) {
      return filter.acceptsAll()
          || emitter
              .identity()
              .doFor(lobby, () -> filter.accepts(waiting.frame.in(emitter), emission.payload()));
    }

    @Override
    public void end(Emission emission, Job emitter) {
      if (emission.noted(this) != null) {
        waiting.holdsNoMore();
      }
    }
  }
}
