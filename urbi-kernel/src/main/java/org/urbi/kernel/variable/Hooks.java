package org.urbi.kernel.variable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.Frame;

/** The hooks of a variable, of one kind. */
final class Hooks {
  private static final Entry[] NONE = {};

  /** A hook, by its number. */
  private static final class Entry {
    private final long id;
    private final Hook hook;
    private boolean removed;

    Entry(long id, Hook hook) {
      this.id = id;
      this.hook = hook;
    }
  }

  /**
   * In the order in which they were added. Copied on write, because hooks that run may add and
   * remove hooks.
   */
  private Entry[] all = NONE;

  private final List<Job> inside = new ArrayList<>(1);

  boolean isEmpty() {
    return all.length == 0;
  }

  int size() {
    return all.length;
  }

  void add(long id, Hook hook) {
    Entry[] more = Arrays.copyOf(all, all.length + 1);
    more[all.length] = new Entry(id, hook);
    all = more;
  }

  boolean remove(long id) {
    for (Entry each : all) {
      if (each.id == id) {
        each.removed = true;
        all = Arrays.stream(all).filter(other -> other != each).toArray(Entry[]::new);
        return true;
      }
    }
    return false;
  }

  /**
   * Runs all hooks, even if one fails. Changes that a hook makes to the variable do not run hooks
   * again.
   */
  void run(Frame frame, UrbiUVar variable, Datum value) {
    if (all.length == 0) {
      return;
    }
    Job job = frame.job();
    boolean again = !inside.isEmpty() && inside.contains(job);
    inside.add(job);
    try {
      for (Entry each : all) {
        if (each.removed || again && !each.hook.isReentrant()) {
          continue;
        }
        try {
          each.hook.run(frame, variable, value);
        } catch (UrbiException e) {
          variable.reportFailure(frame, e.unlessUncatchable());
          if (variable.removesFailed(frame)) {
            remove(each.id);
          }
        }
      }
    } finally {
      inside.remove(job);
    }
  }
}
