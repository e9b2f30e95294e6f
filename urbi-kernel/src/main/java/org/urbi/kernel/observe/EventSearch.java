package org.urbi.kernel.observe;

import java.util.ArrayDeque;
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
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/**
 * Finds the events in slots of objects and of the objects there, and those that reactions wait for,
 * little by little. On the kernel thread.
 */
final class EventSearch {
  /** The slots of how many objects are looked at. */
  private static final int MOST_OBJECTS = 2000;

  private static final int DEEPEST = 3;

  /** An object whose slots are looked at, and the name by which people reach them. */
  private record Step(String name, UrbiObject object, int depth) {}

  private final UrbiObject system;
  private final Map<UrbiEvent, String> names = new LinkedHashMap<>();
  private final Set<UrbiObject> seen = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Deque<Step> left = new ArrayDeque<>();
  private final List<Reaction> reactions;
  private int nextReaction;
  private @Nullable Step step;
  private Symbol[] slots = {};
  private int nextSlot;

  /**
   * @param system who owns the objects of the library
   * @param roots where to begin
   * @param reactions those of the kernel
   */
  EventSearch(UrbiObject system, List<UrbiObject> roots, List<Reaction> reactions) {
    this.system = system;
    this.reactions = reactions;
    roots.forEach(root -> left.add(new Step("", root, 0)));
  }

  /** Goes on, as far as it is allowed; returns whether it is over. */
  boolean goOn(Allowance allowance) {
    while (allowance.isLeft()) {
      allowance.use(1);
      if (step != null && nextSlot < slots.length) {
        look(step, slots[nextSlot++]);
      } else if (!nextObject()) {
        return nameByReactions(allowance);
      }
    }
    return false;
  }

  /** The events that have been found, with their names: those in slots first. */
  Map<UrbiEvent, String> found() {
    return names;
  }

  private boolean nextObject() {
    Step following = seen.size() < MOST_OBJECTS ? left.poll() : null;
    step = following;
    if (following == null) {
      return false;
    }
    boolean isNew = seen.add(following.object());
    slots = isNew ? following.object().localSlotNames() : new Symbol[0];
    nextSlot = 0;
    return true;
  }

  private void look(Step at, Symbol slot) {
    UrbiObject value = at.object().localSlot(slot);
    if (value instanceof UrbiEvent event && event.ownerLobby() != system) {
      names.putIfAbsent(event, at.name() + slot.name());
    } else if (value != null && at.depth() < DEEPEST && isPlain(value)) {
      left.add(new Step(at.name() + slot.name() + ".", value, at.depth() + 1));
    }
  }

  /** Whether the slots of an object may be of interest: it is the user's, and no value. */
  private boolean isPlain(UrbiObject value) {
    return value.getClass() == UrbiObject.class && value.ownerLobby() != system;
  }

  private boolean nameByReactions(Allowance allowance) {
    for (; nextReaction < reactions.size() && allowance.isLeft(); nextReaction++) {
      allowance.use(1);
      Reaction reaction = reactions.get(nextReaction);
      Reaction.Facts facts = reaction.facts();
      UrbiEvent event = facts.event();
      if (event != null && !names.containsKey(event)) {
        List<String> read = reaction.read(1);
        names.put(
            event,
            facts.kind().equals("watch") || read.isEmpty()
                ? Written.beginning(facts.span())
                : read.getFirst());
      }
    }
    return nextReaction == reactions.size();
  }
}
