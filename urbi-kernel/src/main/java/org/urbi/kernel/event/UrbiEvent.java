package org.urbi.kernel.event;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** An event (manual, "Event"). */
public final class UrbiEvent extends UrbiObject implements SlotUpdate.Signal {
  private final Set<Subscription> subscriptions = new LinkedHashSet<>();
  private final Set<Emission> lasting = new LinkedHashSet<>();
  private final Occurrences emissions = new Occurrences();
  private final long number;
  private Map<Subscription, UrbiSubscription> known = Map.of();

  /** Who has subscribed, of lobbies that may not do everything. */
  private Map<Subscription, Guest> guests = Map.of();

  /** How many subscriptions have ended. */
  private long departures;

  private @Nullable Runnable subscribed;

  /** For what lobby, and under which tags, a subscription was made. */
  private record Guest(UrbiObject lobby, TagScope scope) {}

  public UrbiEvent(Shape shape) {
    super(shape);
    number = world().nextEvent();
  }

  /** A number that no other event of the kernel has. */
  public long number() {
    return number;
  }

  /** How often it was emitted, and when last. */
  public Occurrences emissions() {
    return emissions;
  }

  /** How many listen to it. */
  public int subscriberCount() {
    return subscriptions.size();
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiEvent(cloneShape());
  }

  /** Whether anybody listens. */
  public boolean hasSubscribers() {
    return !subscriptions.isEmpty();
  }

  /**
   * Adds a subscription; emissions that are in progress begin for it at once. The event in the slot
   * {@code onSubscribe}, if any, is emitted.
   */
  public void subscribe(Subscription subscription, Job job) {
    subscriptions.add(subscription);
    if (!job.isOwner()) {
      if (guests.isEmpty()) {
        guests = new IdentityHashMap<>();
      }
      guests.put(subscription, new Guest(job.lobby(), job.scopeForNew()));
    }
    for (Emission emission : new ArrayList<>(lasting)) {
      begin(emission, subscription, job);
    }
    if (subscribed != null) {
      subscribed.run();
    }
    if (lookup(world().symbol("onSubscribe")) instanceof UrbiEvent told) {
      told.emit(job, false);
    }
  }

  /** Like {@link #subscribe(Subscription, Job)}, with an object that controls the subscription. */
  void subscribe(Subscription subscription, UrbiSubscription terms, Job job) {
    know(subscription, terms);
    subscribe(subscription, job);
  }

  private void know(Subscription subscription, UrbiSubscription terms) {
    if (known.isEmpty()) {
      known = new IdentityHashMap<>();
    }
    known.put(subscription, terms);
  }

  /**
   * The subscriptions in order of their creation, each always as the same object.
   *
   * @param shape the shape of objects to be created
   */
  public List<UrbiSubscription> subscribers(Supplier<Shape> shape) {
    List<UrbiSubscription> all = new ArrayList<>();
    for (Subscription subscription : subscriptions) {
      UrbiSubscription terms = known.get(subscription);
      if (terms == null) {
        terms = new UrbiSubscription(shape.get(), this, subscription);
        if (subscription instanceof Reaction reaction) {
          terms.setOwnerLobby(reaction.facts().lobby());
        }
        know(subscription, terms);
      }
      all.add(terms);
    }
    return all;
  }

  /** Sets an action of the library that runs at each new subscription. */
  public void setOnSubscribe(Runnable action) {
    subscribed = action;
  }

  public void unsubscribe(Subscription subscription) {
    if (subscriptions.remove(subscription)) {
      departures++;
    }
    if (!known.isEmpty()) {
      known.remove(subscription);
    }
    if (!guests.isEmpty()) {
      guests.remove(subscription);
    }
  }

  /** Whether code has subscribed that may not do everything. */
  boolean hasGuests() {
    return !guests.isEmpty();
  }

  /**
   * Has a subscription begin or end in a job of its own, if its lobby may do less than the emitter:
   * who emits does not wait for it, nor is ended with it.
   *
   * @return whether it does so
   */
  boolean setApart(Subscription subscription, Job emitter, Job.Body body) {
    Guest guest = guests.get(subscription);
    if (guest == null || !emitter.identity().isAbove(guest.lobby)) {
      return false;
    }
    startFor(subscription, emitter.scheduler(), guest.lobby, guest.scope, body);
    return true;
  }

  /** Does something for a subscription in a job of its own, if it is still there by then. */
  private void startFor(
      Subscription subscription,
      Scheduler scheduler,
      UrbiObject lobby,
      TagScope scope,
      Job.Body body) {
    scheduler.startDetached(
        lobby,
        scope,
        "at",
        job -> {
          if (subscriptions.contains(subscription)) {
            body.run(job);
          }
        });
  }

  /** Emits the event without duration. */
  @Override
  public void emit(Frame frame, UrbiObject... payload) {
    emit(frame.job(), false, payload);
  }

  /**
   * Emits the event for no time.
   *
   * @param sync whether to wait for the handlers
   */
  public void emit(Job emitter, boolean sync, UrbiObject... payload) {
    emissions.note(emitter.scheduler().now());
    // Each handler enters and leaves before the next one is called.
    switch (subscriptions.size()) {
      case 0 -> {}
      case 1 -> flash(subscriptions.iterator().next(), emitter, sync, payload);
      default -> {
        long before = departures;
        for (Subscription subscription : new ArrayList<>(subscriptions)) {
          if (departures == before || subscriptions.contains(subscription)) {
            flash(subscription, emitter, sync, payload);
          }
        }
      }
    }
  }

  /**
   * Emits the event when nobody's code does: each reaction begins in a job of its own lobby, under
   * its own tags, with all that it begins, and none waits for another one.
   *
   * @param others gives the lobby for which those are told that are no code; on first use
   */
  public void emitApart(
      Scheduler scheduler, Supplier<? extends UrbiObject> others, UrbiObject... payload) {
    emissions.note(scheduler.now());
    List<Subscription> left = new ArrayList<>();
    for (Subscription subscription : new ArrayList<>(subscriptions)) {
      if (subscription instanceof Reaction reaction) {
        Reaction.Facts of = reaction.facts();
        if (!of.scope().isSilent()) {
          startFor(
              subscription,
              scheduler,
              of.lobby(),
              of.scope(),
              job -> flash(subscription, job, false, payload));
        }
      } else {
        left.add(subscription);
      }
    }
    if (!left.isEmpty()) {
      scheduler.startDetached(
          others.get(),
          scheduler.rootScope(),
          "at",
          job -> {
            for (Subscription subscription : left) {
              if (subscriptions.contains(subscription)) {
                flash(subscription, job, false, payload);
              }
            }
          });
    }
  }

  private void flash(Subscription subscription, Job emitter, boolean sync, UrbiObject[] payload) {
    if (!guests.isEmpty()
        && setApart(subscription, emitter, job -> flash(subscription, job, sync, payload))) {
      return;
    }
    Emission emission = new Emission(this, payload, sync);
    UrbiSubscription terms = known.get(subscription);
    if (terms == null) {
      emission.flash(subscription, emitter);
    } else {
      terms.gate().call(emitter, job -> emission.flash(subscription, job));
    }
  }

  private void begin(Emission emission, Subscription subscription, Job emitter) {
    if (!guests.isEmpty()
        && setApart(subscription, emitter, job -> begin(emission, subscription, job))) {
      return;
    }
    UrbiSubscription terms = known.get(subscription);
    if (terms == null) {
      emission.begin(subscription, emitter);
    } else {
      terms.gate().call(emitter, job -> emission.begin(subscription, job));
    }
  }

  /** Begins an emission that lasts until it is {@linkplain Emission#end ended}. */
  public Emission trigger(Job emitter, boolean sync, UrbiObject... payload) {
    Emission emission = new Emission(this, payload, sync);
    lasting.add(emission);
    emissions.note(emitter.scheduler().now());
    tell(emission, emitter);
    return emission;
  }

  private void tell(Emission emission, Job emitter) {
    long before = departures;
    for (Subscription subscription : new ArrayList<>(subscriptions)) {
      if (departures == before || subscriptions.contains(subscription)) {
        begin(emission, subscription, emitter);
      }
    }
  }

  void ended(Emission emission) {
    lasting.remove(emission);
  }

  /** The emissions in progress, oldest first. */
  List<Emission> lasting() {
    return new ArrayList<>(lasting);
  }
}
