package org.urbi.kernel.event;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.UrbiObject;

/** One emission of an event: it begins, may last for some time, and ends. */
public final class Emission implements EmissionNote {
  private final UrbiEvent event;
  private final UrbiObject[] payload;
  private final boolean sync;

  /** For which subscriptions it has begun and must end. */
  private List<Subscription> told = List.of();

  private @Nullable Map<Subscription, EmissionNote> notes;
  private boolean over;

  Emission(UrbiEvent event, UrbiObject[] payload, boolean sync) {
    this.event = event;
    this.payload = payload;
    this.sync = sync;
  }

  /** What was sent with the event. */
  public UrbiObject[] payload() {
    return payload;
  }

  /** Whether handlers are to be executed by the job that emits. */
  public boolean isSync() {
    return sync;
  }

  public boolean isOver() {
    return over;
  }

  /** Begins and at once ends for one subscription: for an emission without duration. */
  void flash(Subscription subscription, Job emitter) {
    subscription.begin(this, emitter);
    over = true;
    subscription.end(this, emitter);
  }

  /** Begins for one subscription; if the emission has ended already, it ends at once. */
  void begin(Subscription subscription, Job emitter) {
    boolean late = over;
    if (told.isEmpty()) {
      told = new ArrayList<>();
    }
    told.add(subscription);
    subscription.begin(this, emitter);
    if (late) {
      subscription.end(this, emitter);
    }
  }

  /** Ends the emission for all subscriptions that it has begun for and that are still active. */
  public void end(Job emitter) {
    if (!over) {
      over = true;
      event.ended(this);
      for (Subscription subscription : told) {
        if (!event.hasGuests()
            || !event.setApart(subscription, emitter, job -> subscription.end(this, job))) {
          subscription.end(this, emitter);
        }
      }
    }
  }

  /** Keeps a note of a subscription, until the end of the emission. */
  public void note(Subscription subscription, EmissionNote note) {
    if (notes == null) {
      notes = new IdentityHashMap<>();
    }
    notes.put(subscription, note);
  }

  /** The note of a subscription, or null. */
  public @Nullable EmissionNote noted(Subscription subscription) {
    return notes == null ? null : notes.get(subscription);
  }
}
