package org.urbi.kernel.lobby;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.grammar.Keywords;

/**
 * Completes the text that somebody is typing: by names of slots and, at the beginning of an
 * expression, by keywords. No function is called to find them, so the result of a call has no
 * completions.
 */
public final class Completion {
  private Completion() {}

  /**
   * @param text what has been typed: {@code if (robot.body.he}
   * @return the possible last names in alphabetical order: {@code head}, {@code heading}
   */
  public static List<String> of(UrbiObject lobby, String text) {
    String[] path = path(text).split("\\.", -1);
    String begun = path[path.length - 1];
    Set<String> names = new TreeSet<>();
    if (path.length > 1 || !begun.isEmpty()) {
      UrbiObject owner = lobby;
      for (int i = 0; i < path.length - 1 && owner != null; i++) {
        owner = value(lobby, owner, path[i]);
      }
      if (owner != null) {
        addSlots(names, owner);
      }
      if (path.length == 1) {
        names.addAll(Keywords.all());
      }
    }
    return names.stream().filter(name -> name.startsWith(begun)).toList();
  }

  /** The names and dots at the end. */
  private static String path(String text) {
    int start = text.length();
    while (start > 0
        && (Character.isJavaIdentifierPart(text.charAt(start - 1))
            || text.charAt(start - 1) == '.')) {
      start--;
    }
    return text.substring(start);
  }

  /** The object of that name; null if it cannot be found without calling a function. */
  private static @Nullable UrbiObject value(UrbiObject lobby, UrbiObject owner, String name) {
    if (owner == lobby && name.equals("this")) {
      return lobby;
    }
    UrbiObject value = owner.lookup(owner.world().symbol(name));
    return value instanceof Code ? null : value;
  }

  private static void addSlots(Set<String> names, UrbiObject owner) {
    Set<UrbiObject> seen = new LinkedHashSet<>();
    List<UrbiObject> left = new ArrayList<>(List.of(owner));
    while (!left.isEmpty()) {
      UrbiObject object = left.removeLast();
      if (seen.add(object)) {
        for (Symbol slot : object.localSlotNames()) {
          // Skip operators: they are not written after a dot.
          if (slot.name().chars().allMatch(Character::isJavaIdentifierPart)) {
            names.add(slot.name());
          }
        }
        Collections.addAll(left, object.protos());
      }
    }
  }
}
