package org.urbi.kernel.library.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** What the text about a type has to have: a word and an example for each slot. */
final class Completeness {
  private Completeness() {}

  /**
   * What is missing in a text, in sentences; empty when nothing is.
   *
   * @param declared the slots with builtins
   * @param present all slots that the type has
   */
  static List<String> missing(Optional<TypeText> text, Set<String> declared, Set<String> present) {
    List<String> missing = new ArrayList<>();
    if (text.isEmpty()) {
      return List.of("nothing is written about it");
    }
    Set<String> left = new TreeSet<>(declared);
    left.addAll(present);
    for (TypeText.Part part : text.get().parts()) {
      String code = code(part);
      for (String name : part.names()) {
        if (!left.remove(name)) {
          missing.add("no such slot, or twice: " + name);
        }
        if (!code.contains(used(name))) {
          missing.add("no example for " + name);
        }
      }
    }
    left.forEach(name -> missing.add("no text about " + name));
    if (text.get().parts().getFirst().markdown().isEmpty()) {
      missing.add("it is not said what it is for");
    }
    return missing;
  }

  /** Whether a text has the name of its type as title, and names in the headings of its slots. */
  static boolean isWellFormed(String type, String text) {
    return text.startsWith("# " + type + "\n")
        && text.lines().noneMatch(line -> line.startsWith("### ") && !line.contains("`"));
  }

  private static String code(TypeText.Part part) {
    StringBuilder code = new StringBuilder();
    for (Example example : Example.in(part.markdown())) {
      code.append(String.join("\n", example.input())).append('\n');
    }
    return code.toString();
  }

  /** How code that uses a slot shows it. */
  private static String used(String name) {
    return switch (name) {
      case "init" -> ".new";
      case "[]" -> "[";
      case "[]=" -> "] =";
      default -> name;
    };
  }
}
