package org.urbi.kernel.event;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.job.WeakAttachment;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Profiler;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code at (expression ~ duration) … onleave …}. */
public final class AtCondition extends Node {
  private final Node condition;
  private final @Nullable Node duration;
  private final Node body;
  private final @Nullable Node onLeave;
  private final boolean sync;

  /**
   * @param duration how long the condition must hold, or null
   * @param onLeave may be null
   */
  public AtCondition(
      Span span,
      Node condition,
      @Nullable Node duration,
      Node body,
      @Nullable Node onLeave,
      boolean sync) {
    super(span);
    this.condition = condition;
    this.duration = duration;
    this.body = body;
    this.onLeave = onLeave;
    this.sync = sync;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    long hold = Durations.nanoseconds(frame, duration);
    Frame home = frame.fork(frame.job(), false);
    var armed = new Armed(new Handler(home, body, onLeave, sync), hold);
    armed.handler.scope().add(armed.attachment);
    armed.watch.begin(frame.job(), () -> armed.stopped(null));
    return frame.interpreter().values().voidObject;
  }

  /** An {@code at} that has been executed and waits. */
  private final class Armed implements ExpressionWatcher.Listener, Reaction {
    private final Handler handler;
    private final long hold;
    private final ExpressionWatcher watch;
    private final WeakAttachment attachment = new WeakAttachment(this);
    private boolean holds;
    private boolean entered;
    private Timers.@Nullable Timer timer;

    Armed(Handler handler, long hold) {
      this.handler = handler;
      this.hold = hold;
      Job creator = handler.home().job();
      Node watched =
          creator.observer() == null
              ? condition
              : Profiler.observing(creator, "at: { " + condition.span().text() + " }", condition);
      this.watch = new ExpressionWatcher(handler.home(), watched, this);
    }

    /** While the condition holds, stopping its tag must run the {@code onleave} clause. */
    private void setEntered(boolean on) {
      entered = on;
      attachment.keep(on);
    }

    @Override
    public void evaluated(UrbiObject value, Job evaluator) {
      if (handler.scope().isSilent()) {
        return;
      }
      boolean before = holds;
      try {
        holds = Truth.of(handler.home().in(evaluator), value);
      } catch (UrbiException e) {
        throw handler.home().located(e, condition.span());
      }
      if (holds == before) {
        return;
      }
      if (holds) {
        if (hold == 0) {
          setEntered(true);
          handler.enter(handler.home(), evaluator, false);
        } else {
          timer =
              handler.later(
                  evaluator,
                  hold,
                  job -> {
                    timer = null;
                    if (holds) {
                      setEntered(true);
                      handler.enter(handler.home(), job, true);
                    }
                  });
        }
      } else {
        if (timer != null) {
          timer.cancel();
          timer = null;
        }
        if (entered) {
          setEntered(false);
          handler.leave(handler.home(), evaluator, false);
        }
      }
    }

    @Override
    public Facts facts() {
      return handler.facts(span(), null);
    }

    @Override
    public List<String> read(int most) {
      return watch.read(most);
    }

    @Override
    public void stopped(@Nullable TagScope by) {
      watch.close();
      if (timer != null) {
        timer.cancel();
      }
      handler.scope().remove(attachment);
      if (entered) {
        entered = false;
        handler.leaveStopped(handler.home(), by);
      }
    }
  }
}
