package org.urbi.kernel.library.concurrent;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.event.Emission;
import org.urbi.kernel.event.FunctionHandler;
import org.urbi.kernel.event.Subscription;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.event.UrbiSubscription;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;

/** Events (manual, "Event"). */
@UrbiType(
    value = "Event",
    doc = "Something that is emitted and caught.",
    needs = Permission.NOTHING)
public final class EventType {
  private EventType() {}

  /** The slot {@code onSubscribe} is there, so that it can be assigned. */
  public static void fill(UrbiObject prototype) {
    OwnSlots.put(prototype, "onSubscribe", prototype.world().values().voidObject);
  }

  @Builtin(doc = "The event itself.")
  static UrbiObject asEvent(UrbiEvent self) {
    return self;
  }

  @Builtin(
      doc = "Emits the event with that payload; handlers run in the background.",
      needs = Permission.CHANGE)
  static void emit(Frame frame, UrbiEvent self, UrbiObject... payload) {
    self.emit(frame.job(), false, payload);
  }

  @Builtin(
      doc = "Emits the event with that payload, and waits for the handlers.",
      needs = Permission.CHANGE)
  static void syncEmit(Frame frame, UrbiEvent self, UrbiObject... payload) {
    self.emit(frame.job(), true, payload);
  }

  @Builtin(
      doc = "Emits the event until the method stop of what it returns is called.",
      needs = Permission.CHANGE)
  static UrbiObject trigger(Frame frame, UrbiEvent self, UrbiObject... payload) {
    return handle(frame, self.trigger(frame.job(), false, payload));
  }

  @Builtin(
      doc = "Like trigger, and waits for the handlers at both ends.",
      needs = Permission.CHANGE)
  static UrbiObject syncTrigger(Frame frame, UrbiEvent self, UrbiObject... payload) {
    return handle(frame, self.trigger(frame.job(), true, payload));
  }

  private static UrbiObject handle(Frame frame, Emission emission) {
    UrbiObject proto = frame.interpreter().world().prototype("EventHandler");
    return new UrbiEmission(proto.cloneShape(), emission);
  }

  @Builtin(
      value = {"<<"},
      doc = "Emits this event, too, each time another one is emitted.",
      needs = Permission.CHANGE)
  static UrbiObject watch(Frame frame, UrbiEvent self, UrbiEvent other) {
    other.subscribe(new Relay(self), frame.job());
    return self;
  }

  @Builtin(
      value = {"||"},
      doc = "An event emitted each time one of both is.")
  static UrbiObject either(Frame frame, UrbiEvent self, UrbiEvent other) {
    UrbiEvent either = (UrbiEvent) frame.interpreter().prototypes().event.cloned();
    watch(frame, either, self);
    watch(frame, either, other);
    return either;
  }

  @Builtin(doc = "Whether anybody listens.")
  static boolean hasSubscribers(UrbiEvent self) {
    return self.hasSubscribers();
  }

  @Builtin(
      doc =
          "Calls functions with the event and the list of what is sent with it: enter when the"
              + " guard does not return void, leave when the emission is over; as at does.")
  static UrbiObject onEvent(
      Frame frame,
      UrbiEvent self,
      UrbiObject guard,
      UrbiObject enter,
      @Optional @Nullable UrbiObject leave,
      @Optional @Nullable UrbiObject sync) {
    boolean wait = sync != null && Truth.of(frame, sync);
    UrbiSubscription subscription =
        (UrbiSubscription) self.world().prototype("Subscription").cloned();
    subscription.setListener(
        (home, event) -> FunctionHandler.guarded(home, event, guard, enter, leave, wait));
    subscription.listenTo(frame, self);
    return subscription;
  }

  @Builtin(doc = "Has a subscription listen to this event; returns it.")
  static UrbiObject subscribe(Frame frame, UrbiEvent self, UrbiSubscription subscription) {
    PermissionCheck.checkChange(frame, "subscribe", subscription);
    if (!subscription.canListen()) {
      throw frame
          .interpreter()
          .errors()
          .primitive("subscribe", Problem.SUBSCRIPTION_WITHOUT_FUNCTION);
    }
    subscription.listenTo(frame, self);
    return subscription;
  }

  @Builtin(doc = "The subscriptions of those who listen.")
  static List<UrbiSubscription> subscribers(UrbiEvent self) {
    return self.subscribers(self.world().prototype("Subscription")::cloneShape);
  }

  /** Emits an event as another one is emitted. */
  private static final class Relay implements Subscription {
    private final UrbiEvent to;
    private boolean busy;

    Relay(UrbiEvent to) {
      this.to = to;
    }

    @Override
    public void begin(Emission emission, Job emitter) {
      // Events that watch one another would go on for ever.
      if (!busy) {
        busy = true;
        try {
          emission.note(this, to.trigger(emitter, emission.isSync(), emission.payload()));
        } finally {
          busy = false;
        }
      }
    }

    @Override
    public void end(Emission emission, Job emitter) {
      if (emission.noted(this) instanceof Emission relayed) {
        relayed.end(emitter);
      }
    }
  }
}
