package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** No room of the kernel knows all the others: that is for the few classes that put it together. */
class KnownRoomsTest {
  private static final Path KERNEL = Path.of("..", "urbi-kernel", "src", "main", "java");

  /** How many other packages of the kernel a class may import from. */
  private static final int MOST = 10;

  /** The classes that put the kernel together, and the library; they know no more than they do. */
  private static final Map<String, Integer> COMPOSITION =
      Map.of("org.urbi.kernel.Kernel", 24, "org.urbi.kernel.library.Library", 12);

  private static final Pattern OWN = Pattern.compile("(?m)^package ([\\w.]+);");
  private static final Pattern IMPORTED =
      Pattern.compile("(?m)^import (?:static )?(org\\.urbi\\.kernel(?:\\.[a-z]\\w*)*)\\.[A-Z]");

  /** The packages of the kernel from which a source file imports. */
  private static Set<String> imported(String source) {
    String own = OWN.matcher(source).results().findFirst().orElseThrow().group(1);
    return IMPORTED
        .matcher(source)
        .results()
        .map((MatchResult found) -> found.group(1))
        .filter(other -> !other.equals(own))
        .collect(Collectors.toSet());
  }

  private static List<Path> sources() throws IOException {
    try (Stream<Path> files = Files.walk(KERNEL)) {
      return files.filter(file -> file.toString().endsWith(".java")).toList();
    }
  }

  private static String name(Path source) {
    String path = KERNEL.relativize(source).toString();
    return path.substring(0, path.length() - ".java".length()).replace('/', '.');
  }

  @Test
  void noClassKnowsAllRooms() throws IOException {
    Map<String, Integer> tooMany = new TreeMap<>();
    for (Path source : sources()) {
      int known = imported(Files.readString(source, StandardCharsets.UTF_8)).size();
      if (known > COMPOSITION.getOrDefault(name(source), MOST)) {
        tooMany.put(name(source), known);
      }
    }
    assertEquals(Map.of(), tooMany);
  }

  @Test
  void whatIsImportedIsCountedOnce() {
    assertEquals(
        Set.of("org.urbi.kernel.job", "org.urbi.kernel.library.math", "org.urbi.kernel"),
        imported(
            """
            package org.urbi.kernel.node;

            import static org.urbi.kernel.job.Job.of;

            import java.util.List;
            import org.urbi.kernel.Kernel;
            import org.urbi.kernel.job.Job;
            import org.urbi.kernel.job.Scheduler;
            import org.urbi.kernel.library.math.FloatType;
            import org.urbi.kernel.node.Frame;
            import urbi.UValue;
            """));
  }
}
