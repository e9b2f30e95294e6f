package org.urbi.kernel.object;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Goes through an object and all from which it inherits, each once, depth first and in the order of
 * the prototypes: however many there are, without recurring.
 */
final class Ancestors {
  /** After so many steps it is asked whether to go on; a power of two. */
  private static final int STEPS_PER_QUESTION = 1 << 12;

  private final Set<UrbiObject> visited = new HashSet<>();

  /** What is still to be visited, next one last. */
  private final Deque<UrbiObject> pending = new ArrayDeque<>();

  Ancestors(UrbiObject from) {
    pending.push(from);
  }

  /** The next one; null when there is none. */
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
