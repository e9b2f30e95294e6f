package org.urbi.kernel.journal;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Objects that are listed here, and not kept alive by that. Which of them the garbage collector has
 * taken is recorded whenever somebody looks: a replay keeps them itself until then, whatever its
 * own collector does. On the kernel thread.
 *
 * @param <T> what they are
 */
public final class LooseObjects<T> {
  private static final int FEW = 64;

  private final Journal journal;

  /** By their numbers, the oldest first. */
  private final Map<Long, WeakReference<T>> listed = new LinkedHashMap<>(0);

  /** The objects that must not become garbage: while somebody looks; in a replay, all. */
  private final Map<Long, T> kept = new LinkedHashMap<>(0);

  private long last;
  private int tidyAt = FEW;

  public LooseObjects(Journal journal) {
    this.journal = journal;
  }

  /** Whether nothing is listed. */
  public boolean isEmpty() {
    return listed.isEmpty();
  }

  /** One more object; from time to time those that are gone are forgotten. */
  public void add(T object) {
    if (listed.size() >= tidyAt) {
      all();
      tidyAt = Math.max(FEW, 2 * listed.size());
    }
    listed.put(++last, new WeakReference<>(object));
    if (journal.isReplay()) {
      kept.put(last, object);
    }
  }

  /** Forgets an object, if it is listed. */
  public void remove(T object) {
    listed
        .entrySet()
        .removeIf(each -> {
          boolean found = each.getValue().refersTo(object);
          if (found) {
            kept.remove(each.getKey());
          }
          return found;
        });
  }

  /** The objects that are not garbage, the oldest first. */
  public List<T> all() {
    if (listed.isEmpty()) {
      return List.of();
    }
    for (long number : journal.ask(this::gone)) {
      listed.remove(number);
      kept.remove(number);
    }
    List<T> present = List.copyOf(kept.values());
    if (!journal.isReplay()) {
      kept.clear();
    }
    return present;
  }

  /** Keeps those that are still there, and returns the numbers of the others. */
  private List<Long> gone() {
    List<Long> gone = new ArrayList<>(0);
    listed.forEach((number, reference) -> {
      T object = reference.get();
      if (object == null) {
        gone.add(number);
      } else {
        kept.put(number, object);
      }
    });
    return gone;
  }
}
