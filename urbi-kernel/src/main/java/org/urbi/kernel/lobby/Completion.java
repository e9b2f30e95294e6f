package org.urbi.kernel.lobby;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
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
    return List.copyOf(found(lobby, text).keySet());
  }

  /**
   * The possible last names, as of {@link #of}, with the values of the slots of that name; keywords
   * have none.
   */
  public static Map<String, Optional<UrbiObject>> found(UrbiObject lobby, String text) {
    Map<String, Optional<UrbiObject>> found = new TreeMap<>();
    String[] path = path(text).split("\\.", -1);
    String begun = path[path.length - 1];
    if (path.length > 1 || !begun.isEmpty()) {
      UrbiObject owner = lobby;
      for (int i = 0; i < path.length - 1 && owner != null; i++) {
        owner = value(lobby, owner, path[i]);
      }
      if (path.length == 1) {
        Keywords.all().stream()
            .filter(name -> name.startsWith(begun))
            .forEach(name -> found.put(name, Optional.empty()));
      }
      if (owner != null) {
        addSlots(found, owner, begun);
      }
    }
    return found;
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

  private static void addSlots(
      Map<String, Optional<UrbiObject>> found, UrbiObject owner, String begun) {
    Set<UrbiObject> seen = new LinkedHashSet<>();
    List<UrbiObject> left = new ArrayList<>(List.of(owner));
    while (!left.isEmpty()) {
      UrbiObject object = left.removeLast();
      if (seen.add(object)) {
        for (Symbol slot : object.localSlotNames()) {
          // Skip operators: they are not written after a dot.
          if (slot.name().startsWith(begun)
              && slot.name().chars().allMatch(Character::isJavaIdentifierPart)) {
            found.put(slot.name(), Optional.ofNullable(owner.lookup(slot)));
          }
        }
        Collections.addAll(left, object.protos());
      }
    }
  }
}
