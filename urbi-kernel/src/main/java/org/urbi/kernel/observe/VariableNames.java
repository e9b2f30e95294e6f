package org.urbi.kernel.observe;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.variable.UrbiUVar;

/**
 * The names by which people know the objects of variables: the shortest way to them over slots,
 * {@code robot.body.head.yaw}. It looks at a limited number of objects.
 */
final class VariableNames {
  private static final int MOST_OBJECTS = 5000;
  private static final int DEEPEST = 8;

  /** Their slots lead everywhere. */
  private static final Set<String> SKIPPED = Set.of("uobjects", "parent", "Lobby", "Global");

  private record Step(UrbiObject object, String path, int depth) {}

  private final Map<UrbiObject, String> names = new IdentityHashMap<>();
  private final Deque<Step> left = new ArrayDeque<>();

  /**
   * @param roots the objects whose slots are known without a prefix
   */
  VariableNames(List<? extends UrbiObject> roots) {
    Set<UrbiObject> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    seen.addAll(roots);
    roots.forEach(root -> left.add(new Step(root, "", 0)));
    for (Step step = left.poll(); step != null && seen.size() < MOST_OBJECTS; step = left.poll()) {
      visit(step, seen);
    }
  }

  private void visit(Step from, Set<UrbiObject> seen) {
    for (Symbol slot : from.object.localSlotNames()) {
      UrbiObject value = from.object.localSlot(slot);
      if (value == null
          || value instanceof Code
          || value instanceof UrbiUVar
          || SKIPPED.contains(slot.name())
          || !Symbol.isWord(slot.name())
          || value.ownerLobby() == value.world().values().object
          || !seen.add(value)) {
        continue;
      }
      String path = from.path + Utf8Text.toJava(slot.name());
      names.put(value, path);
      if (from.depth < DEEPEST) {
        left.add(new Step(value, path + ".", from.depth + 1));
      }
    }
  }

  /** How many objects have a name. */
  int size() {
    return names.size();
  }

  /** Whether there is a way to the object of a variable. */
  boolean knows(UrbiUVar variable) {
    UrbiObject owner = variable.owner();
    return owner != null && names.containsKey(owner);
  }

  /** The name of a variable; its own if there is no way to it. */
  String of(UrbiUVar variable) {
    UrbiObject owner = variable.owner();
    String path = owner == null ? null : names.get(owner);
    String own = Utf8Text.toJava(variable.name());
    return path == null ? own : path + own.substring(own.lastIndexOf('.'));
  }
}
