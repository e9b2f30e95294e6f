package org.urbi.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class ResultTest {
  private static Result result(Map<Language, Double> figures, Target target) {
    return new Result("fib", "fib(25)", Unit.TIME, figures, Map.of(), target, "");
  }

  private static final Target PYTHON = new Target.Ratio(Language.PYTHON, 1);

  @Test
  void ratioTargetIsMetUpToTheRatio() {
    Map<Language, Double> even = Map.of(Language.URBISCRIPT, 2e6, Language.PYTHON, 2e6);
    assertEquals("met", result(even, PYTHON).verdict());
    Map<Language, Double> slower = Map.of(Language.URBISCRIPT, 2.1e6, Language.PYTHON, 2e6);
    assertEquals("MISSED", result(slower, PYTHON).verdict());
  }

  @Test
  void noClaimWithoutTheOtherLanguage() {
    Result alone = result(Map.of(Language.URBISCRIPT, 2e6), PYTHON);
    assertEquals("unknown", alone.verdict());
    assertNull(alone.ratioTo(Language.PYTHON));
  }

  @Test
  void failedProgramDoesNotMeetItsTarget() {
    assertEquals("unknown", result(Map.of(), new Target.Absolute(20, Unit.TIME)).verdict());
  }

  @Test
  void medianOfEvenAndOddNumbers() {
    assertEquals(3, Comparison.median(List.of(9.0, 1.0, 3.0)));
    assertEquals(2.5, Comparison.median(List.of(4.0, 1.0, 3.0, 2.0)));
  }

  @Test
  void tableHasAColumnForEachLanguageThatWasThere() {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    Result result = result(Map.of(Language.URBISCRIPT, 15e6, Language.PYTHON, 30e6), PYTHON);
    new Table(List.of(result)).print(new PrintStream(bytes));
    List<String> lines = bytes.toString().lines().toList();
    assertEquals(
        List.of("program", "urbiscript", "CPython", "/ CPython", "target"),
        List.of(lines.getFirst().split(" {2,}")));
    assertEquals(
        List.of("fib(25)", "15.00 ms", "30.00 ms", "0.50", "<= 1.0 x CPython", "met"),
        List.of(lines.get(1).split(" {2,}")));
  }

  @Test
  void jsonQuotes() {
    String json =
        Json.of(
            List.of("a \"machine\""),
            List.of(result(Map.of(Language.URBISCRIPT, 15e6), new Target.None())));
    assertTrue(json.contains("\"a \\\"machine\\\"\""), json);
    assertTrue(json.contains("\"median\": {\"urbiscript\": 15000000.0}"), json);
  }

  @Test
  void everyRowHasItsPrograms() {
    var programs = java.nio.file.Path.of("programs");
    for (Row row : Row.all()) {
      assertTrue(
          java.nio.file.Files.exists(Language.URBISCRIPT.program(programs, row.program())),
          row.program());
    }
  }
}
