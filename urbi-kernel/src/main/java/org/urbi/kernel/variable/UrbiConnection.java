package org.urbi.kernel.variable;

import org.urbi.kernel.event.UrbiSubscription;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** Leads each new value of one variable to another (manual, "Customizing data-flow links"). */
public final class UrbiConnection extends UrbiSubscription {
  private UrbiUVar source;
  private UrbiUVar target;

  public UrbiConnection(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiConnection(cloneShape());
  }

  /** Leads the values of a variable to another from now on. */
  public void connect(Frame frame, UrbiUVar from, UrbiUVar to) {
    disconnect();
    source = from;
    target = to;
    from.add(frame, this);
  }

  /** Leads nothing any more. */
  @Override
  public void disconnect() {
    if (source != null) {
      source.remove(this);
      source = null;
    }
  }

  /** Where the values come from; null when it is disconnected. */
  public UrbiUVar source() {
    return source;
  }

  /** Where they go; null for the prototype. */
  public UrbiUVar target() {
    return target;
  }

  /** There is a new value. */
  void pass(Frame frame, Datum value) {
    Interpreter interpreter = frame.interpreter();
    Job caller = frame.job();
    gate()
        .call(
            caller,
            job ->
                target.write(
                    job == caller
                        ? frame
                        : Frame.top(interpreter, job, job.lobby(), new FrameLayout()),
                    value));
  }
}
