package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The page on the architecture has each package of each module in a table, and no other. */
class ArchitecturePageTest {
  private static final Pattern MODULE =
      Pattern.compile(
          "(?m)^### (\\S+)\\n\\n\\| package \\| .*\\n\\|---\\|---\\|\\n((?:\\|.*\\n)+)");
  private static final Pattern NAME = Pattern.compile("`([\\w.]+)`");

  /** The names in the first column of the table of each module. */
  private static Map<String, TreeSet<String>> tables() throws IOException {
    Map<String, TreeSet<String>> tables = new HashMap<>();
    Matcher module =
        MODULE.matcher(
            Files.readString(Path.of("../docs/architecture.md"), StandardCharsets.UTF_8));
    while (module.find()) {
      var names = new TreeSet<String>();
      module
          .group(2)
          .lines()
          .forEach(row ->
              NAME.matcher(row.split("\\|", -1)[1])
                  .results()
                  .forEach(name -> names.add(name.group(1))));
      tables.put(module.group(1), names);
    }
    return tables;
  }

  /** The package that is called so for short: the shortest whose name ends so. */
  private static String inFull(String name, List<String> packages) {
    return packages.stream()
        .filter(full -> full.equals(name) || full.endsWith("." + name))
        .min(Comparator.comparing(String::length))
        .orElse(name + ", which there is not");
  }

  @Test
  void eachPackageIsInItsTable() throws IOException {
    Map<String, TreeSet<String>> tables = tables();
    RoomOrder.MODULES.forEach((module, packages) -> {
      var described = new TreeSet<String>();
      tables
          .getOrDefault(module, new TreeSet<>())
          .forEach(name -> described.add(inFull(name, packages)));
      assertEquals(new TreeSet<>(packages), described, module);
    });
  }
}
