package org.urbi.kernel.library.reference;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.text.StringDistance;

/** The texts of the reference, by what they are about. They are read when they are asked for. */
final class HelpTexts {
  /** The text about the language itself. */
  static final String KEYWORDS = "keywords";

  private static final String ITEM = "* ";

  /** How many names are proposed for one that is unknown. */
  private static final int PROPOSED = 3;

  /** All of them, by the names of the types. */
  private static final class All {
    private static final List<String> TYPES =
        TypeText.resource("index.md")
            .orElseThrow()
            .lines()
            .filter(line -> line.startsWith(ITEM))
            .map(line -> line.substring(ITEM.length()))
            .toList();

    private static final Map<String, TypeText> TEXTS = read();

    private static Map<String, TypeText> read() {
      Map<String, TypeText> texts = new TreeMap<>();
      for (String type : TYPES) {
        TypeText.of(type).ifPresent(text -> texts.put(type, text));
      }
      TypeText.of(KEYWORDS).ifPresent(text -> texts.put(KEYWORDS, text));
      return texts;
    }
  }

  private HelpTexts() {}

  /** The names of all types. */
  static List<String> types() {
    return All.TYPES;
  }

  /** The text about a slot of a type itself, or null. */
  static TypeText.@Nullable Part slot(String type, String slot) {
    TypeText text = All.TEXTS.get(type);
    if (text != null) {
      for (TypeText.Part part : text.parts()) {
        if (part.names().contains(slot)) {
          return part;
        }
      }
    }
    return null;
  }

  /** What a type is for, or null. */
  static @Nullable String introduction(String type) {
    TypeText text = All.TEXTS.get(type);
    return text == null ? null : text.parts().getFirst().markdown();
  }

  /** The names of the slots that the text about a type explains, in its order. */
  static List<String> slots(String type) {
    TypeText text = All.TEXTS.get(type);
    return text == null
        ? List.of()
        : text.parts().stream().flatMap(part -> part.names().stream()).toList();
  }

  /** The types that have a slot of that name of their own. */
  static List<String> typesWith(String slot) {
    return All.TEXTS.keySet().stream().filter(type -> slots(type).contains(slot)).toList();
  }

  /** The topics that may be meant by one that there is not, the likeliest first. */
  static List<String> near(String wrong, List<String> others) {
    List<String> candidates = new ArrayList<>(others);
    int dot = wrong.lastIndexOf('.');
    String type = dot < 0 ? "" : wrong.substring(0, dot);
    if (All.TEXTS.containsKey(type)) {
      slots(type).forEach(slot -> candidates.add(type + "." + slot));
    } else {
      All.TEXTS.forEach((name, text) -> {
        candidates.add(name);
        slots(name).forEach(slot -> candidates.add(dot < 0 ? slot : name + "." + slot));
      });
    }
    List<String> near = new ArrayList<>();
    while (near.size() < PROPOSED) {
      String closest = StringDistance.closest(wrong, candidates, () -> {});
      if (closest == null) {
        break;
      }
      near.add(closest);
      candidates.removeIf(closest::equals);
    }
    near.sort(Comparator.comparingInt(one -> StringDistance.distance(wrong, one, () -> {})));
    return near;
  }
}
