package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The rows that somebody has been sent, so that only changes are sent from then on. On the kernel
 * thread.
 *
 * @param <K> by what a row is known
 * @param <R> a record: rows with equal components are the same to people
 */
final class SentRows<K, R> {
  private final Map<K, R> told = new HashMap<>();
  private final Set<K> present = new HashSet<>();
  private final List<R> changes = new ArrayList<>();

  /** A row is there. */
  void is(K key, R row) {
    present.add(key);
    if (!row.equals(told.put(key, row))) {
      changes.add(row);
    }
  }

  /** The rows that are new or have changed, since this was last asked. */
  List<R> changes() {
    List<R> all = List.copyOf(changes);
    changes.clear();
    return all;
  }

  /** What is there no longer, since this was last asked: what was not said to be there since. */
  List<K> gone() {
    List<K> gone = new ArrayList<>();
    if (told.size() > present.size()) {
      for (Iterator<K> each = told.keySet().iterator(); each.hasNext(); ) {
        K key = each.next();
        if (!present.contains(key)) {
          gone.add(key);
          each.remove();
        }
      }
    }
    present.clear();
    return gone;
  }
}
