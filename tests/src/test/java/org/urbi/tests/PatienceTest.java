package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** No test knows how busy the machine is: one limit, in the pom, is for all. */
class PatienceTest {
  private static final Pattern LIMIT = Pattern.compile("@" + "Timeout\\b|\\.orTimeout\\(");

  @Test
  void noTestHasALimitOfItsOwn() throws IOException {
    try (Stream<Path> files = Files.walk(Path.of(".."))) {
      List<Path> tests =
          files
              .filter(file -> file.toString().contains("/src/test/java/"))
              .filter(file -> file.toString().endsWith(".java"))
              .toList();
      assertTrue(tests.size() > 100, tests.toString());
      List<Path> limited = tests.stream().filter(PatienceTest::hasLimit).toList();
      assertEquals(List.of(), limited);
    }
  }

  private static boolean hasLimit(Path file) {
    try {
      String source = Files.readString(file, StandardCharsets.UTF_8);
      return !file.endsWith("PatienceTest.java") && LIMIT.matcher(source).find();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
