package org.urbi.kernel.variable;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.UrbiSubscription;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** Copies each new value of one variable to another (manual, "Customizing data-flow links"). */
public final class UrbiConnection extends UrbiSubscription {
  private @Nullable UrbiUVar source;
  private @Nullable UrbiUVar target;

  public UrbiConnection(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiConnection(cloneShape());
  }

  /** Starts to copy the values of a variable to another. */
  public void connect(Frame frame, UrbiUVar from, UrbiUVar to) {
    disconnect();
    source = from;
    target = to;
    from.add(frame, this);
  }

  /** Ends the connection. */
  @Override
  public void disconnect() {
    if (source != null) {
      source.remove(this);
      source = null;
    }
  }

  /** The source of the values; null when disconnected. */
  public @Nullable UrbiUVar source() {
    return source;
  }

  /** The target of the values; null for the prototype. */
  public @Nullable UrbiUVar target() {
    return target;
  }

  /** Passes on a new value. */
  void pass(Frame frame, Datum value) {
    Interpreter interpreter = frame.interpreter();
    Job caller = frame.job();
    UrbiUVar to = requireNonNull(target, "values come when it is connected");
    gate()
        .call(
            caller,
            job ->
                to.write(
                    job == caller
                        ? frame
                        : Frame.top(interpreter, job, job.lobby(), new FrameLayout()),
                    value));
  }
}
