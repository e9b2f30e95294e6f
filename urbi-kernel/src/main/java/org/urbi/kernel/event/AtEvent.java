package org.urbi.kernel.event;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.job.WeakAttachment;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code at (event?(…) if … ~ duration) … onleave …}. */
public final class AtEvent extends Node {
  private final Node event;
  private final EventFilter filter;
  private final @Nullable Node duration;
  private final Node body;
  private final @Nullable Node onLeave;
  private final boolean sync;

  /**
   * @param duration how long the emission must last, or null
   * @param onLeave may be null
   */
  public AtEvent(
      Span span,
      Node event,
      EventFilter filter,
      @Nullable Node duration,
      Node body,
      @Nullable Node onLeave,
      boolean sync) {
    super(span);
    this.event = event;
    this.filter = filter;
    this.duration = duration;
    this.body = body;
    this.onLeave = onLeave;
    this.sync = sync;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    UrbiEvent source = EventLookup.event(frame, event);
    long hold = Durations.nanoseconds(frame, duration);
    // Later activations of the same code must not share variables with this one.
    Frame home = frame.fork(frame.job(), false);
    var armed = new Armed(source, new Handler(home, body, onLeave, sync), hold);
    armed.handler.scope().add(armed.attachment);
    source.subscribe(armed, frame.job());
    return frame.interpreter().values().voidObject;
  }

  /** An {@code at} that has been executed and waits. */
  private final class Armed implements Subscription, Reaction {
    private final UrbiEvent source;
    private final Handler handler;
    private final long hold;
    private final WeakAttachment attachment = new WeakAttachment(this);
    private boolean stopped;

    Armed(UrbiEvent source, Handler handler, long hold) {
      this.source = source;
      this.handler = handler;
      this.hold = hold;
    }

    @Override
    public void begin(Emission emission, Job emitter) {
      if (handler.scope().isSilent()) {
        return;
      }
      Frame matched = handler.home();
      if (!filter.acceptsAll()) {
        matched = matched.fork(emitter, false);
        Frame scene = matched;
        if (!emitter
            .identity()
            .doFor(handler.lobby(), () -> filter.accepts(scene, emission.payload()))) {
          return;
        }
      }
      if (hold > 0) {
        Frame frame = matched;
        var waiting = new Waiting();
        waiting.timer =
            handler.later(
                emitter,
                hold,
                job -> {
                  if (!stopped) {
                    waiting.entered = frame;
                    handler.enter(frame, job, true);
                  }
                });
        emission.note(this, waiting);
        return;
      }
      if (handler.hasLeave()) {
        var waiting = new Waiting();
        waiting.entered = matched;
        emission.note(this, waiting);
      }
      handler.enter(matched, emitter, emission.isSync());
    }

    @Override
    public void end(Emission emission, Job emitter) {
      if (emission.noted(this) instanceof Waiting waiting) {
        if (waiting.timer != null) {
          waiting.timer.cancel();
        }
        if (waiting.entered != null && !stopped && !handler.scope().isStopping()) {
          handler.leave(waiting.entered, emitter, emission.isSync());
        }
      }
    }

    @Override
    public Facts facts() {
      return handler.facts(span(), source);
    }

    @Override
    public List<String> read(int most) {
      return List.of(AtEvent.this.event.span().text());
    }

    @Override
    public void stopped(@Nullable TagScope by) {
      stopped = true;
      source.unsubscribe(this);
      handler.scope().remove(attachment);
    }
  }

  /** An emission that has been accepted, or will be if it lasts long enough. */
  static final class Waiting implements EmissionNote {
    Timers.@Nullable Timer timer;
    @Nullable Frame entered;
  }
}
