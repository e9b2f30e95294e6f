package org.urbi.builtins;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The texts of the reference, a file in Markdown for each type: {@code Float.md} has {@code ###
 * `sin`, `cos`} above what is told of these slots, with an example.
 */
final class ReferenceTexts {
  /** The compiler's option that names their folder; without it nothing is looked for. */
  static final String OPTION = "urbi.reference";

  private static final Pattern NAME = Pattern.compile("`([^`]+)`");
  private static final String FENCE = "```";
  private static final String EXAMPLE = "```urbiscript";

  private final @Nullable Path folder;

  /** Whether there is an example below the heading with a slot's name, by type and slot. */
  private final Map<String, Map<String, Boolean>> types = new HashMap<>();

  ReferenceTexts(@Nullable String folder) {
    this.folder = folder == null ? null : Path.of(folder);
  }

  /** What is missing about a slot, as a sentence; null when nothing is. */
  @Nullable String missing(String type, String slot) {
    if (folder == null) {
      return null;
    }
    Path file = folder.resolve(type + ".md");
    Boolean example = types.computeIfAbsent(type, name -> read(file)).get(slot);
    if (example == null) {
      return "the reference says nothing of `" + slot + "': ### `" + slot + "` in " + file;
    }
    return example ? null : "the reference has no example of `" + slot + "': " + file;
  }

  private static Map<String, Boolean> read(Path file) {
    List<String> lines;
    try {
      lines = Files.readAllLines(file);
    } catch (IOException e) {
      return Map.of();
    }
    Map<String, Boolean> slots = new HashMap<>();
    List<String> names = List.of();
    boolean code = false;
    for (String line : lines) {
      if (!code && line.startsWith("##")) {
        names = line.startsWith("### ") ? names(line) : List.of();
        names.forEach(name -> slots.put(name, false));
      }
      if (line.startsWith(EXAMPLE)) {
        names.forEach(name -> slots.put(name, true));
      }
      code ^= line.startsWith(FENCE);
    }
    return slots;
  }

  private static List<String> names(String heading) {
    Matcher matcher = NAME.matcher(heading);
    return matcher.results().map(found -> found.group(1)).toList();
  }
}
