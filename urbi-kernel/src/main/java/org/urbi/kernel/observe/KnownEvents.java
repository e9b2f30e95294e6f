package org.urbi.kernel.observe;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.Reaction;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/**
 * Finds the reactions of a kernel, and the events: those in slots of lobbies, of the object Global
 * and of the objects there, and those that reactions wait for. Nobody keeps lists of them, so that
 * they cost nothing while nobody looks. On the kernel thread.
 */
public final class KnownEvents {
  /** The slots of how many objects are looked at. */
  private static final int MOST_OBJECTS = 2000;

  private static final int DEEPEST = 3;

  private record Step(String name, UrbiObject object, int depth) {}

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

  /** The events with their names: those in slots first, then those that only reactions know. */
  Map<UrbiEvent, String> events(List<Reaction> reactions) {
    Map<UrbiEvent, String> names = new LinkedHashMap<>();
    Set<UrbiObject> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<Step> left = new ArrayDeque<>();
    places.rootObjects().forEach(root -> left.add(new Step("", root, 0)));
    for (Step at = left.poll(); at != null && seen.size() < MOST_OBJECTS; at = left.poll()) {
      if (seen.add(at.object())) {
        look(at, names, left);
      }
    }
    for (Reaction reaction : reactions) {
      Reaction.Facts facts = reaction.facts();
      UrbiEvent event = facts.event();
      if (event != null) {
        List<String> read = reaction.read(1);
        names.putIfAbsent(
            event,
            facts.kind().equals("watch") || read.isEmpty()
                ? Written.beginning(facts.span())
                : read.getFirst());
      }
    }
    return names;
  }

  private void look(Step at, Map<UrbiEvent, String> names, Deque<Step> left) {
    for (Symbol slot : at.object().localSlotNames()) {
      UrbiObject value = at.object().localSlot(slot);
      if (value instanceof UrbiEvent event && event.ownerLobby() != system) {
        names.putIfAbsent(event, at.name() + slot.name());
      } else if (value != null && isPlain(value) && at.depth() < DEEPEST) {
        left.add(new Step(at.name() + slot.name() + ".", value, at.depth() + 1));
      }
    }
  }

  /** Whether the slots of an object may be of interest: it is the user's, and no value. */
  private boolean isPlain(UrbiObject value) {
    return value.getClass() == UrbiObject.class && value.ownerLobby() != system;
  }

  /** The event of that number; null if there is none, or it is known no longer. */
  public @Nullable UrbiEvent event(long number) {
    for (UrbiEvent event : events(reactions()).keySet()) {
      if (event.number() == number) {
        return event;
      }
    }
    return null;
  }
}
