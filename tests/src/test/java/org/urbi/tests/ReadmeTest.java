package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** README names every module and every tool. */
class ReadmeTest {
  private static final Path ROOT = Path.of("..");
  private static final Pattern MODULE = Pattern.compile("<module>(.*?)</module>");

  private static String read(String file) throws IOException {
    return Files.readString(ROOT.resolve(file), StandardCharsets.UTF_8);
  }

  private static List<String> missing(List<String> names) throws IOException {
    String readme = read("README.md");
    return names.stream().filter(name -> !readme.contains("`" + name + "`")).toList();
  }

  @Test
  void everyModuleIsNamed() throws IOException {
    List<String> modules = new ArrayList<>();
    MODULE.matcher(read("pom.xml")).results().forEach(found -> modules.add(found.group(1)));
    assertTrue(modules.size() > 5, modules.toString());
    assertEquals(List.of(), missing(modules));
  }

  @Test
  void everyToolIsNamed() throws IOException {
    try (Stream<Path> tools = Files.list(ROOT.resolve("bin"))) {
      List<String> names = tools.map(tool -> "bin/" + tool.getFileName()).toList();
      assertTrue(names.size() > 5, names.toString());
      assertEquals(List.of(), missing(names));
    }
  }
}
