package org.urbi.kernel.journal;

import java.lang.ref.WeakReference;
import org.jspecify.annotations.Nullable;

/**
 * A reference that does not keep its object alive. That the garbage collector has taken the object
 * is recorded when somebody looks: a replay keeps it itself until then, whatever its own collector
 * does. On the kernel thread.
 *
 * @param <T> what the object is
 */
public final class LooseReference<T> {
  private final Journal journal;

  /** Null once the object was found to be gone: that is recorded once. */
  private @Nullable WeakReference<T> reference;

  /** The object, in a replay. */
  private @Nullable T kept;

  public LooseReference(Journal journal, T object) {
    this.journal = journal;
    this.reference = new WeakReference<>(object);
    this.kept = journal.isReplay() ? object : null;
  }

  /** The object; null once it is gone. */
  public @Nullable T get() {
    WeakReference<T> there = reference;
    if (there == null) {
      return null;
    }
    T object = there.get();
    if (journal.misses(object == null)) {
      clear();
      return null;
    }
    return object;
  }

  /**
   * The object, if it is there; for those whose look is not part of the run, since a replay may
   * look at another time.
   */
  public @Nullable T peek() {
    WeakReference<T> there = reference;
    return there == null ? null : there.get();
  }

  /** From now on it is gone. */
  public void clear() {
    reference = null;
    kept = null;
  }
}
