package org.urbi.kernel.event;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A subscription to an event, or to a variable, as an urbiscript object. */
public class UrbiSubscription extends UrbiObject {
  /** Subscribes to an event. */
  @FunctionalInterface
  public interface Listener {
    Subscription listenTo(Frame frame, UrbiEvent event);
  }

  private final CallPolicy gate = new CallPolicy();
  private @Nullable Listener listener;
  private @Nullable UrbiEvent event;
  private @Nullable Subscription subscription;

  public UrbiSubscription(Shape shape) {
    super(shape);
  }

  /** Represents an existing subscription. */
  UrbiSubscription(Shape shape, UrbiEvent event, Subscription subscription) {
    super(shape);
    this.event = event;
    this.subscription = subscription;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiSubscription(cloneShape());
  }

  public final CallPolicy gate() {
    return gate;
  }

  /** Sets what is called once it {@linkplain #listenTo listens}. */
  public final void setListener(Listener made) {
    listener = made;
  }

  /** Whether it can listen to another event. */
  public final boolean canListen() {
    return listener != null;
  }

  /** Listens to an event from now on, and to no other one. */
  public final void listenTo(Frame frame, UrbiEvent source) {
    disconnect();
    PermissionCheck.claim(frame, this);
    event = source;
    Subscription made = requireNonNull(listener, "it can listen").listenTo(frame, source);
    subscription = made;
    source.subscribe(made, this, frame.job());
  }

  /** Listens no more. */
  public void disconnect() {
    if (subscription instanceof TagScope.Attachment attached) {
      attached.stopped(null);
    } else if (subscription != null && event != null) {
      event.unsubscribe(subscription);
    }
    subscription = null;
  }
}
