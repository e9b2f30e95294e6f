package org.urbi.kernel.object;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Iterates over an object and all objects from which it inherits, each once, depth first and in the
 * order of the prototypes. It does not recurse, however many there are.
 */
final class Ancestors {
  /** After this many steps the check for interruption is called; a power of two. */
  private static final int STEPS_PER_QUESTION = 1 << 12;

  private final Set<UrbiObject> visited = new HashSet<>();

  /** The objects still to be visited; the next one is last. */
  private final Deque<UrbiObject> pending = new ArrayDeque<>();

  Ancestors(UrbiObject from) {
    pending.push(from);
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
