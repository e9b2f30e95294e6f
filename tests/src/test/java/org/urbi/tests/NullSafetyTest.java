package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every package is checked by NullAway, and every suppression of a warning has its reason. */
class NullSafetyTest {
  private static final Path ROOT = Path.of("..");
  private static final Pattern MODULE = Pattern.compile("<module>(.*?)</module>");
  private static final Pattern MARKED = Pattern.compile("(?m)^@NullMarked$");

  /** A warning that is switched off, and the reason at the end of the line, if it stands there. */
  private static final Pattern SUPPRESSED =
      Pattern.compile("^\\s*@SuppressWarnings\\([^)]*\\)(?!.*//)");

  private static String read(Path file) throws IOException {
    return Files.readString(file, StandardCharsets.UTF_8);
  }

  /** The source files of all modules, but for those of tests. */
  private static List<Path> sources() throws IOException {
    List<Path> sources = new ArrayList<>();
    for (String module :
        MODULE
            .matcher(read(ROOT.resolve("pom.xml")))
            .results()
            .map(found -> found.group(1))
            .toList()) {
      Path main = ROOT.resolve(module).resolve("src/main/java");
      if (Files.isDirectory(main)) {
        try (Stream<Path> files = Files.walk(main)) {
          files.filter(file -> file.toString().endsWith(".java")).forEach(sources::add);
        }
      }
    }
    assertTrue(sources.size() > 500, "there are more files than " + sources.size());
    return sources;
  }

  @Test
  void everyPackageIsNullMarked() throws IOException {
    var packages = new TreeSet<Path>();
    sources().forEach(file -> packages.add(file.getParent()));
    List<Path> unmarked = new ArrayList<>();
    for (Path folder : packages) {
      Path info = folder.resolve("package-info.java");
      if (!Files.exists(info) || !MARKED.matcher(read(info)).find()) {
        unmarked.add(folder);
      }
    }
    assertEquals(List.of(), unmarked, "without @NullMarked in their package-info.java");
  }

  @Test
  void nothingIsExcludedFromNullAway() throws IOException {
    List<Path> found = new ArrayList<>();
    for (Path file : sources()) {
      if (read(file).contains("@NullUnmarked")) {
        found.add(file);
      }
    }
    assertEquals(List.of(), found);
  }

  @Test
  void suppressionOfAWarningHasAReason() throws IOException {
    List<String> unreasoned = new ArrayList<>();
    for (Path file : sources()) {
      List<String> lines = read(file).lines().toList();
      for (int i = 0; i < lines.size(); i++) {
        if (SUPPRESSED.matcher(lines.get(i)).find() && !lines.get(i - 1).strip().startsWith("//")) {
          unreasoned.add(file + ":" + (i + 1));
        }
      }
    }
    assertEquals(List.of(), unreasoned);
  }
}
