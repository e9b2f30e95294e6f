package org.urbi.kernel.tier;

import java.lang.classfile.Label;
import java.util.ArrayDeque;
import java.util.Deque;
import org.urbi.kernel.node.Node;

/**
 * Where the quick copy of the turns of a loop goes over to the slow one: to the same place, which
 * is found by its order. So both must be emitted alike, with the same values in the same slots;
 * code for which that is not so is refused.
 */
final class Crossings {
  /**
   * A place of the slow copy.
   *
   * @param at the statement that has just been emitted, or the operation that begins
   * @param slots how many slots are taken there
   */
  private record Crossing(Node at, int slots, Label label) {}

  private final Deque<Crossing> open = new ArrayDeque<>();

  /** A place of the slow copy to which the quick one will go over. */
  void add(Node at, int slots, Label label) {
    open.add(new Crossing(at, slots, label));
  }

  /**
   * The next of these places.
   *
   * @throws IllegalArgumentException if the quick copy is at another place
   */
  Label next(Node at, int slots) {
    Crossing next = open.poll();
    if (next == null || next.at != at || next.slots != slots) {
      throw unlike();
    }
    return next.label;
  }

  /**
   * The quick copy is complete.
   *
   * @throws IllegalArgumentException if there is less in it than in the slow one
   */
  void end() {
    if (!open.isEmpty()) {
      throw unlike();
    }
  }

  /** The copies of a loop are not alike: a bug of ours. */
  private static IllegalArgumentException unlike() {
    return new IllegalArgumentException();
  }
}
