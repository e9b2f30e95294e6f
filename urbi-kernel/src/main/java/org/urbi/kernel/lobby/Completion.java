package org.urbi.kernel.lobby;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Ancestors;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.grammar.Keywords;
import org.urbi.lang.input.TypedText;

/**
 * Completes the text that somebody is typing: by names of slots and, at the beginning of an
 * expression, by local variables and keywords. No function is called to find them: a call has the
 * completions of the type that the library declares for its result.
 */
public final class Completion {
  /** How many names are found at most, the first ones. */
  public static final int MOST = 500;

  private final String begun;
  private final TreeSet<String> names = new TreeSet<>();

  private Completion(String begun) {
    this.begun = begun;
  }

  /**
   * @param text what has been typed: {@code if (robot.body.he}
   * @return the possible last names in alphabetical order: {@code head}, {@code heading}
   */
  public static List<String> of(UrbiObject lobby, String text) {
    return List.copyOf(found(lobby, TypedText.of(text)).keySet());
  }

  /**
   * The possible last names, as of {@link #of}, with the values of the slots of that name; keywords
   * and local variables have none.
   */
  public static Map<String, Optional<UrbiObject>> found(UrbiObject lobby, TypedText typed) {
    if (typed.isInText() || typed.begun().isEmpty() && !typed.isSlot()) {
      return Map.of();
    }
    Completion completion = new Completion(typed.begun());
    String receiver = typed.isSlot() ? typed.receiver() : "this";
    UrbiObject owner = receiver == null ? null : new ExpectedValue(lobby, typed).of(receiver);
    Set<String> local = typed.isSlot() ? Set.of() : typed.locals();
    if (!typed.isSlot()) {
      local.forEach(completion::add);
      Keywords.all().forEach(completion::add);
    }
    if (owner != null) {
      completion.addSlots(owner);
    }
    return completion.withValues(owner, local);
  }

  private void add(String name) {
    if (name.startsWith(begun)
        && (names.size() < MOST || name.compareTo(names.last()) < 0)
        && isTyped(name)
        && names.add(name)
        && names.size() > MOST) {
      names.removeLast();
    }
  }

  /** Operators are not written after a dot, and names with a dollar are not for people. */
  private static boolean isTyped(String name) {
    for (int i = 0; i < name.length(); i++) {
      char character = name.charAt(i);
      if (character == '$' || !Character.isJavaIdentifierPart(character)) {
        return false;
      }
    }
    return true;
  }

  private void addSlots(UrbiObject owner) {
    for (UrbiObject object : Ancestors.of(owner)) {
      for (Symbol slot : object.localSlotNames()) {
        add(slot.name());
      }
    }
  }

  private Map<String, Optional<UrbiObject>> withValues(
      @Nullable UrbiObject owner, Set<String> local) {
    Map<String, Optional<UrbiObject>> found = new TreeMap<>();
    for (String name : names) {
      found.put(
          name,
          owner == null || local.contains(name)
              ? Optional.empty()
              : Optional.ofNullable(owner.lookup(owner.world().symbol(name))));
    }
    return found;
  }
}
