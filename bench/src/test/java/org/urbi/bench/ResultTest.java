package org.urbi.bench;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

class ResultTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();

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
    var machine = new Installation(ROOT);
    for (Row row : Row.constructs()) {
      assertTrue(Files.exists(machine.program(Language.URBISCRIPT, row.program())), row.program());
    }
    for (Row row : Row.everyday()) {
      for (Language language : List.of(Language.URBISCRIPT, Language.PYTHON, Language.LUA)) {
        assertTrue(Files.exists(machine.program(language, row.program())), row.program());
      }
    }
  }

  @Test
  void differentResultsAreAnError() {
    assertThrows(
        Disagreement.class,
        () -> Disagreement.check(Language.URBISCRIPT, "1.000000", Language.LUA, "1.000001"));
    Result wrong = Result.failed("fib", "fib(25)", "results differ");
    assertEquals("WRONG", wrong.verdict());
    assertTrue(wrong.isFailure());
    assertFalse(result(Map.of(Language.URBISCRIPT, 2e6), PYTHON).isFailure());
  }

  @Test
  void growthFasterThanWantedIsAnError() {
    assertTrue(growth(1.11).isFailure());
    assertFalse(growth(1.1).isFailure());
    double[] sizes = {1, 4, 16};
    assertEquals(2, Growth.slope(sizes, new double[] {3, 48, 768}), 1e-9);
  }

  private static Result growth(double exponent) {
    Target target = new Target.Absolute(1.1, Unit.EXPONENT);
    Map<Language, Double> figures = Map.of(Language.URBISCRIPT, exponent);
    return new Result("growth", "jobs", Unit.EXPONENT, figures, Map.of(), target, "");
  }

  @Test
  void meanOfRatiosIsGeometric() {
    Result twice = result(Map.of(Language.URBISCRIPT, 2.0, Language.LUA, 1.0), PYTHON);
    Result eighth = result(Map.of(Language.URBISCRIPT, 1.0, Language.LUA, 8.0), PYTHON);
    Section section = new Section("", List.of(twice, eighth)).withMean(new Target.None());
    Double mean = section.results().getLast().ratioTo(Language.LUA);
    assertEquals(0.5, Objects.requireNonNull(mean), 1e-9);
  }

  @Test
  void latenessIsCountedFromTheEarliestPeriod() {
    double[] late = Lateness.late(DoubleStream.of(5e6, 15e6, 32e6, 35e6));
    assertArrayEquals(new double[] {0, 0, 0, 7e6}, late, 1);
    assertEquals(0, Lateness.at(late, 0.5));
    assertEquals(7e6, Lateness.at(late, 0.999), 1);
  }

  @Test
  void documentIsOfThePresentBenchmarksOrSaysThatItIsOlder() throws IOException {
    var document = new Document(ROOT);
    assertTrue(
        document.isHonest(),
        "docs/benchmarks.md is older than the benchmarks: bench/run --document makes it anew on a"
            + " calm machine; until then it must say: \""
            + Document.OLDER
            + "\"");
  }
}
