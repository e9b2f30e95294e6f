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

/**
 * No test has a time limit of its own: the pom sets one limit for all, because no test knows how
 * busy the machine is.
 */
class TestTimeoutTest {
  private static final Pattern LIMIT =
      Pattern.compile(
          "@Timeout\\b|\\.orTimeout\\("
              + "|\\.(?:poll|get|await)\\(\\d+, TimeUnit\\.(?:SECONDS|MINUTES)\\)"
              + "|\\bLIMIT = Duration\\.of(?:Seconds|Minutes)\\(\\d+\\)");

  @Test
  void noTestHasALimitOfItsOwn() throws IOException {
    try (Stream<Path> files = Files.walk(Path.of(".."))) {
      List<Path> tests =
          files
              .filter(file -> file.toString().contains("/src/test/java/"))
              .filter(file -> file.toString().endsWith(".java"))
              .toList();
      assertTrue(tests.size() > 100, tests.toString());
      List<Path> limited = tests.stream().filter(TestTimeoutTest::hasLimit).toList();
      assertEquals(List.of(), limited);
    }
  }

  private static boolean hasLimit(Path file) {
    try {
      String source = Files.readString(file, StandardCharsets.UTF_8);
      return !file.endsWith("TestTimeoutTest.java") && LIMIT.matcher(source).find();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
