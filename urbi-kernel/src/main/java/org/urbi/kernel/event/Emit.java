package org.urbi.kernel.event;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code event!(arguments) ~ duration}. */
public final class Emit extends Node implements CallSite {
  private final Node event;
  private final Node[] arguments;
  private final @Nullable Node duration;

  /**
   * @param arguments may be empty
   * @param duration how long the event lasts, or null
   */
  public Emit(Span span, Node event, Node[] arguments, @Nullable Node duration) {
    super(span);
    this.event = event;
    this.arguments = arguments;
    this.duration = duration;
  }

  @Override
  public String calledName() {
    return "emit";
  }

  @Override
  public Span calledSpan() {
    return span();
  }

  @Override
  public UrbiObject execute(Frame frame) {
    UrbiObject target = event.execute(frame);
    UrbiObject[] payload = new UrbiObject[arguments.length];
    for (int i = 0; i < payload.length; i++) {
      payload[i] = arguments[i].execute(frame);
    }
    UrbiObject nothing = frame.interpreter().values().voidObject;
    if (!(target instanceof UrbiEvent emitted)) {
      // An object that is no event, but behaves like one, has a method {@code emit} of its own.
      try {
        frame
            .interpreter()
            .send(frame, this, target, frame.interpreter().world().symbol("emit"), payload);
      } catch (UrbiException e) {
        throw frame.located(e, span());
      }
      return nothing;
    }
    try {
      PermissionCheck.checkChange(frame, "emit", emitted);
    } catch (UrbiException e) {
      throw frame.located(e, span());
    }
    if (duration == null) {
      emitted.emit(frame.job(), false, payload);
      return nothing;
    }
    long lasts = Durations.nanoseconds(frame, duration);
    Emission emission = emitted.trigger(frame.job(), false, payload);
    try {
      Job job = frame.job();
      job.at(frame, this).sleepUntil(job.scheduler().deadline(lasts));
    } finally {
      emission.end(frame.job());
    }
    return nothing;
  }
}
