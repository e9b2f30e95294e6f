package org.urbi.kernel.variable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.Frame;

/** The hooks of one kind that a variable has. */
final class Hooks {
  private final Map<Long, Hook> hooks = new LinkedHashMap<>();
  private final List<Job> inside = new ArrayList<>(1);

  boolean isEmpty() {
    return hooks.isEmpty();
  }

  int size() {
    return hooks.size();
  }

  void add(long id, Hook hook) {
    hooks.put(id, hook);
  }

  boolean remove(long id) {
    return hooks.remove(id) != null;
  }

  /**
   * Runs them all; one that fails keeps no other from running. What a hook does to the variable
   * runs none of them again.
   *
   * @param removeFailed whether one that fails is removed
   */
  void run(Frame frame, UrbiUVar variable, Datum value, boolean removeFailed) {
    if (hooks.isEmpty()) {
      return;
    }
    boolean again = inside.contains(frame.job());
    inside.add(frame.job());
    try {
      for (Map.Entry<Long, Hook> each : List.copyOf(hooks.entrySet())) {
        if (!hooks.containsKey(each.getKey()) || again && !each.getValue().isReentrant()) {
          continue;
        }
        try {
          each.getValue().run(frame, variable, value);
        } catch (UrbiException e) {
          variable.reportFailure(frame, e);
          if (removeFailed) {
            hooks.remove(each.getKey());
          }
        }
      }
    } finally {
      inside.remove(frame.job());
    }
  }
}
