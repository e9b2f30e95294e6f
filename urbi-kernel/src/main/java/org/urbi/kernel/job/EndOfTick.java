package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * What is done at the end of a tick. An action for which there is no memory is done again at the
 * end of the next tick: the output of a client, say, must not be lost.
 */
final class EndOfTick {
  /** How many ticks in a row wait for memory. */
  private static final int LONGEST_WANT = 50;

  private final List<Runnable> actions = new ArrayList<>();

  /** How many ticks in a row have left actions. */
  private int wanting;

  void add(Runnable action) {
    actions.add(action);
  }

  boolean isEmpty() {
    return actions.isEmpty();
  }

  /**
   * Runs the actions, and those that they add.
   *
   * @param failed told what an action throws; the others run all the same
   */
  void run(Consumer<Throwable> failed) {
    int kept = 0;
    for (int next = 0; next < actions.size(); next++) {
      Runnable action = actions.get(next);
      try {
        action.run();
      } catch (OutOfMemoryError e) {
        if (wanting < LONGEST_WANT) {
          actions.set(kept++, action);
        } else {
          failed.accept(e);
        }
      } catch (Throwable failure) {
        failed.accept(failure);
      }
    }
    while (actions.size() > kept) {
      actions.removeLast();
    }
    wanting = kept == 0 ? 0 : wanting + 1;
  }
}
