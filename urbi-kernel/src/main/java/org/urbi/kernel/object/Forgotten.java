package org.urbi.kernel.object;

import java.lang.ref.Cleaner;

/** Tells when urbiscript objects that nobody knows any more have been garbage collected. */
public final class Forgotten {
  /** Has a thread, so that it is created only when there is something to be told. */
  private static final Cleaner CLEANER = Cleaner.create();

  private Forgotten() {}

  /**
   * Runs an action on a thread of its own when an object has been garbage collected.
   *
   * @param action does not wait, and does not lead to the object, which would keep it for ever
   */
  public static void whenGone(UrbiObject object, Runnable action) {
    CLEANER.register(object, action);
  }
}
