package org.urbi.kernel.event;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Dependencies;

/**
 * What the last evaluation of an expression has read, and is watched therefore. Usually each
 * evaluation reads the same things in the same order as the one before, and finds each watch with
 * one comparison.
 */
public final class WatchedSources implements Dependencies.Tracker {
  /** Up to so many are searched one by one. */
  private static final int FEW = 8;

  private final Dependencies.Watcher watcher;

  /** The watches of the evaluation before, in the order of its reading. */
  private List<Dependencies.Watch> before = new ArrayList<>(4);

  /** The watches of this evaluation. */
  private List<Dependencies.Watch> now = new ArrayList<>(4);

  /** All of them by what they watch, if there are many and an evaluation reads in another order. */
  private @Nullable Map<Dependencies, Dependencies.Watch> known;

  private long evaluation;

  /**
   * @param watcher called when something changes that was read
   */
  public WatchedSources(Dependencies.Watcher watcher) {
    this.watcher = watcher;
  }

  /** An evaluation begins. What was read before is watched until it {@linkplain #end ends}. */
  public void begin() {
    evaluation++;
    List<Dependencies.Watch> empty = before;
    before = now;
    now = empty;
  }

  /** Watches a source at once: others may change it before the evaluation has ended. */
  @Override
  public void read(Dependencies source) {
    int next = now.size();
    if (next < before.size()) {
      Dependencies.Watch expected = before.get(next);
      if (expected.source() == source && expected.readBy(evaluation)) {
        now.add(expected);
        return;
      }
    }
    Dependencies.Watch watch = find(source);
    if (watch == null) {
      watch = source.add(watcher);
      if (known != null) {
        known.put(source, watch);
      }
    }
    if (watch.readBy(evaluation)) {
      now.add(watch);
    }
  }

  private Dependencies.@Nullable Watch find(Dependencies source) {
    if (known == null) {
      if (before.size() <= FEW && now.size() <= FEW) {
        Dependencies.Watch found = find(source, now);
        return found == null ? find(source, before) : found;
      }
      known = new IdentityHashMap<>(2 * now.size());
      for (Dependencies.Watch watch : before) {
        known.put(watch.source(), watch);
      }
      for (Dependencies.Watch watch : now) {
        known.put(watch.source(), watch);
      }
    }
    return known.get(source);
  }

  private static Dependencies.@Nullable Watch find(
      Dependencies source, List<Dependencies.Watch> among) {
    for (int i = 0; i < among.size(); i++) {
      Dependencies.Watch watch = among.get(i);
      if (watch.source() == source) {
        return watch;
      }
    }
    return null;
  }

  /** The evaluation has ended: what it has not read is not watched any more. */
  public void end() {
    for (int i = 0; i < before.size(); i++) {
      Dependencies.Watch watch = before.get(i);
      if (!watch.wasReadBy(evaluation)) {
        watch.end();
      }
    }
    before.clear();
    known = null;
  }

  /** The names of what the last evaluation has read, each once, in the order of its reading. */
  List<String> names(int most) {
    List<String> names = new ArrayList<>();
    for (int i = 0; i < now.size() && names.size() < most; i++) {
      String name = now.get(i).source().name();
      if (!name.isEmpty() && !names.contains(name)) {
        names.add(name);
      }
    }
    return names;
  }

  /** Watches nothing any more. */
  public void close() {
    before.forEach(Dependencies.Watch::end);
    now.forEach(Dependencies.Watch::end);
    before.clear();
    now.clear();
    known = null;
  }
}
