package org.urbi.kernel.object;

import java.lang.ref.WeakReference;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Iterates over an object and all objects from which it inherits, each once, depth first and in the
 * order of the prototypes. It does not recurse, however many there are.
 */
public final class Ancestors {
  /** After this many steps the check for interruption is called; a power of two. */
  private static final int STEPS_PER_QUESTION = 1 << 12;

  /** Of an object with more of them they are not remembered: there are few such objects. */
  private static final int FEW = 64;

  /**
   * An object and its ancestors, as they are until some object gets other prototypes. What is no
   * ancestor any more is not kept alive.
   *
   * @param epoch that of the world when they were found
   */
  record Known(List<WeakReference<UrbiObject>> objects, int epoch) {}

  private final Set<UrbiObject> visited = new HashSet<>();

  /** The objects still to be visited; the next one is last. */
  private final Deque<UrbiObject> pending = new ArrayDeque<>();

  Ancestors(UrbiObject from) {
    pending.push(from);
  }

  /** An object and all from which it inherits, in the order of lookup. */
  public static Set<UrbiObject> of(UrbiObject object) {
    Set<UrbiObject> all = new LinkedHashSet<>();
    Ancestors ancestors = new Ancestors(object);
    for (UrbiObject next = ancestors.next(); next != null; next = ancestors.next()) {
      next.noteStructureRead();
      all.add(next);
    }
    return all;
  }

  /** An object and its ancestors, to be remembered; null if they are many. */
  static @Nullable Known find(UrbiObject from) {
    List<WeakReference<UrbiObject>> found = new ArrayList<>();
    Ancestors ancestors = new Ancestors(from);
    for (UrbiObject next = ancestors.next(); next != null; next = ancestors.next()) {
      if (found.size() == FEW) {
        return null;
      }
      found.add(new WeakReference<>(next));
    }
    return new Known(List.copyOf(found), from.world().protosEpoch);
  }

  /** The first one that has a slot of its own of that name, or null. */
  static @Nullable UrbiObject holder(UrbiObject from, Symbol name) {
    List<WeakReference<UrbiObject>> known = from.knownAncestors();
    if (known != null) {
      for (int i = 0; i < known.size(); i++) {
        UrbiObject at = known.get(i).get();
        if (at != null && at.shape().indexOf(name) >= 0) {
          return at;
        }
      }
      return null;
    }
    Ancestors ancestors = new Ancestors(from);
    UrbiObject next = ancestors.next();
    while (next != null && next.shape().indexOf(name) < 0) {
      next = ancestors.next();
    }
    return next;
  }

  /** Whether an object is among them. */
  static boolean contain(UrbiObject from, UrbiObject wanted) {
    List<WeakReference<UrbiObject>> known = from.knownAncestors();
    if (known != null) {
      for (int i = 0; i < known.size(); i++) {
        if (known.get(i).refersTo(wanted)) {
          return true;
        }
      }
      return false;
    }
    Ancestors ancestors = new Ancestors(from);
    UrbiObject next = ancestors.next();
    while (next != null && next != wanted) {
      next = ancestors.next();
    }
    return next != null;
  }

  /** The next object; null at the end. */
  @Nullable UrbiObject next() {
    while (!pending.isEmpty()) {
      UrbiObject next = pending.pop();
      if (visited.add(next)) {
        if (visited.size() % STEPS_PER_QUESTION == 0) {
          next.world().passCheckpoint();
        }
        UrbiObject[] protos = next.shape().protos;
        for (int i = protos.length - 1; i >= 0; i--) {
          pending.push(protos[i]);
        }
        return next;
      }
    }
    return null;
  }
}
