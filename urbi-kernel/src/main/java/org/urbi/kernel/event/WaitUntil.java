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
    switch (condition) {
      case Condition.WhenEmitted emitted -> await(frame, emitted, hold);
      case Condition.WhenTrue holds -> await(frame, holds, hold);
    }
    return frame.interpreter().values().voidObject;
  }

  private void await(Frame frame, Condition.WhenEmitted condition, long hold) {
    UrbiEvent source = EventLookup.event(frame, condition.event());
    var waiting = new ForEvent(frame, this, condition.filter(), hold);
    source.subscribe(waiting, frame.job());
    try {
      waiting.await();
    } catch (UrbiException e) {
      throw frame.located(e, condition.event().span());
    } finally {
      source.unsubscribe(waiting);
      waiting.close();
    }
  }

  private void await(Frame frame, Condition.WhenTrue condition, long hold) {
    var waiting = new ForExpression(frame, this, condition.expression(), hold);
    try {
      waiting.watch.begin(frame.job());
      waiting.await();
    } catch (UrbiException e) {
      throw frame.located(e, condition.expression().span());
    } finally {
      waiting.watch.close();
      waiting.close();
    }
  }

  /** A job that waits. */
  private abstract static class Waiting {
    final Frame frame;
    private final Job job;
    private final Node place;
    private final Wait what;
    private final long hold;
    private Timers.@Nullable Timer timer;
    private boolean done;

    Waiting(Frame frame, Node place, Wait what, long hold) {
      this.frame = frame;
      this.place = place;
      this.what = what;
      this.job = frame.job();
      this.hold = hold;
    }

    void holds() {
      if (hold == 0) {
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

    boolean isDone() {
      return done;
    }

    void await() {
      while (!done) {
        job.at(frame, place).waitForWake(what);
      }
    }

    void close() {
      holdsNoMore();
    }
  }

  /** Waits for an expression to be true. */
  private static final class ForExpression extends Waiting implements ExpressionWatcher.Listener {
    private final ExpressionWatcher watch;

    ForExpression(Frame frame, Node place, Node expression, long hold) {
      super(frame, place, Wait.CONDITION, hold);
      watch = new ExpressionWatcher(frame, expression, this);
    }

    @Override
    public void evaluated(UrbiObject value, Job evaluator) {
      if (Truth.of(frame.in(evaluator), value)) {
        holds();
      } else {
        holdsNoMore();
      }
    }
  }

  /** Waits for an event. */
  private static final class ForEvent extends Waiting implements Subscription {
    private final EventFilter filter;
    private final UrbiObject lobby;

    ForEvent(Frame frame, Node place, EventFilter filter, long hold) {
      super(frame, place, Wait.EVENT, hold);
      this.filter = filter;
      lobby = frame.job().lobby();
    }

    @Override
    public void begin(Emission emission, Job emitter) {
      // The pattern binds variables of the waiting code; only the first matching event binds them.
      if (!isDone()
          && !frame.job().isFrozen()
          && emitter
              .onBehalf()
              .doFor(lobby, () -> filter.accepts(frame.in(emitter), emission.payload()))) {
        emission.note(this, this);
        holds();
      }
    }

    @Override
    public void end(Emission emission, Job emitter) {
      if (emission.noted(this) != null) {
        holdsNoMore();
      }
    }
  }
}
