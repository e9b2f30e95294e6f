package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.Reaction;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.object.UrbiObject;

/**
 * Finds the reactions of a kernel, and the events: those in slots of lobbies, of the object Global
 * and of the objects there, and those that reactions wait for. Nobody keeps lists of them, so that
 * they cost nothing while nobody looks. On the kernel thread.
 */
public final class KnownEvents {
  private final Scheduler scheduler;
  private final UrbiObject system;
  private final Places places;

  /**
   * @param places where to look for events
   * @param system who owns the objects of the library
   */
  public KnownEvents(Scheduler scheduler, Places places, UrbiObject system) {
    this.scheduler = scheduler;
    this.places = places;
    this.system = system;
  }

  /** The reactions, the oldest of each tag first. */
  List<Reaction> reactions() {
    List<Reaction> all = new ArrayList<>();
    for (TagScope.Attachment each : scheduler.rootScope().allAttachments()) {
      if (each.handler() instanceof Reaction reaction) {
        all.add(reaction);
      }
    }
    return all;
  }

  /** Begins to look for the events. */
  EventSearch search(List<Reaction> reactions) {
    return new EventSearch(system, places.rootObjects(), reactions);
  }

  /** The event of that number; null if there is none, or it is known no longer. */
  public @Nullable UrbiEvent event(long number) {
    EventSearch search = search(reactions());
    while (!search.goOn(new Allowance())) {
      // Whoever emits it does not wait for less.
    }
    for (UrbiEvent event : search.found().keySet()) {
      if (event.number() == number) {
        return event;
      }
    }
    return null;
  }
}
