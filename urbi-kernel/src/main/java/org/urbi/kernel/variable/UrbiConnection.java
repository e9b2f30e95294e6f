package org.urbi.kernel.variable;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.UrbiSubscription;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** Copies each new value of one variable to another (manual, "Customizing data-flow links"). */
public final class UrbiConnection extends UrbiSubscription {
  private static final String CONNECTED = "values come when it is connected";

  private @Nullable UrbiUVar source;
  private @Nullable UrbiUVar target;
  private @Nullable UrbiObject maker;

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
    PermissionCheck.claim(frame, this);
    source = from;
    target = to;
    maker = frame.job().lobby();
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

  /** Passes on a new value, for the lobby that has made the connection. */
  void pass(Frame frame, Datum value) {
    UrbiUVar to = requireNonNull(target, CONNECTED);
    UrbiObject lobby = requireNonNull(maker, CONNECTED);
    Job caller = frame.job();
    gate()
        .call(
            caller,
            job -> job.identity().doFor(lobby, () -> to.write(at(frame, caller, job), value)));
  }

  private static Frame at(Frame frame, Job caller, Job job) {
    return job == caller
        ? frame
        : Frame.top(frame.interpreter(), job, job.lobby(), new FrameLayout());
  }
}
