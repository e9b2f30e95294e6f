package org.urbi.kernel.object;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * The watchers of one thing that can change (a slot, the set of slots of an object, the content of
 * a container, a local variable): the conditions which read it when they were last evaluated.
 */
public final class Dependencies {
  /** A condition that must be evaluated again after a change. */
  public interface Watcher {
    /** Something that the condition read has changed. */
    void invalidated();
  }

  /** Collects what the evaluation of a condition reads. */
  public interface Tracker {
    /** The condition has read this. */
    void read(Dependencies source);
  }

  private final Set<Watcher> watchers = new LinkedHashSet<>();

  /** Adds a watcher, which is called at each change until it is removed. */
  public void add(Watcher watcher) {
    watchers.add(watcher);
  }

  public void remove(Watcher watcher) {
    watchers.remove(watcher);
  }

  public boolean isEmpty() {
    return watchers.isEmpty();
  }

  /** Calls every watcher, in the order in which they were added. */
  public void changed() {
    switch (watchers.size()) {
      case 0 -> {}
      case 1 -> watchers.iterator().next().invalidated();
      default -> {
        // Iterate over a copy: watchers are added and removed while they are called.
        List<Watcher> told = new ArrayList<>(watchers);
        for (Watcher watcher : told) {
          if (watchers.contains(watcher)) {
            watcher.invalidated();
          }
        }
      }
    }
  }
}
