package org.urbi.kernel.job;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.function.Function;

/** The end of many things, and of all that is to end with them; very many end in pieces. */
public final class EndInPieces<T> extends Stop {
  private final Deque<T> left;
  private final Function<T, Collection<T>> end;

  private EndInPieces(Collection<T> all, Function<T, Collection<T>> end) {
    this.left = new ArrayDeque<>(all);
    this.end = end;
  }

  /**
   * Ends each of them: at once, or in the next ticks if there are very many.
   *
   * @param end ends one, and returns what is to end in the same way; if memory is wanting it is
   *     called again
   */
  public static <T> void begin(
      Scheduler scheduler, Collection<T> all, Function<T, Collection<T>> end) {
    if (!all.isEmpty()) {
      scheduler.stops().begin(new EndInPieces<>(all, end));
    }
  }

  @Override
  boolean step() {
    T next = left.peek();
    if (next == null) {
      return false;
    }
    left.addAll(end.apply(next));
    left.remove();
    return true;
  }

  /** What ends is not what jobs execute. */
  @Override
  void reach(Job job) {}
}
