package org.urbi.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * How long a fresh process takes for work that takes CPython, warm, so and so long: from the start
 * of the process until the result is there.
 */
final class FreshProcesses {
  private static final long CALIBRATION = 40_000_000;
  private static final int MAX_TIMES = 1 << 20;

  private final Installation machine;
  private final long work;
  private final int rounds;

  /**
   * @param work how long it takes CPython, in nanoseconds
   * @param rounds how many processes of each language count
   */
  FreshProcesses(Installation machine, long work, int rounds) {
    this.machine = machine;
    this.work = work;
    this.rounds = rounds;
  }

  /** Measures one program. */
  Result run(Row row) {
    Map<Language, List<Double>> samples = new EnumMap<>(Language.class);
    List<Language> languages = new ArrayList<>(List.of(Language.URBISCRIPT));
    languages.addAll(row.languages());
    try {
      int times = timesFor(row);
      for (int round = 0; round < rounds; round++) {
        String first = null;
        for (Language language : languages) {
          long start = System.nanoTime();
          Optional<LanguageProcess> started =
              LanguageProcess.start(machine, language, row.program(), "");
          if (started.isEmpty()) {
            continue;
          }
          try (LanguageProcess process = started.get()) {
            process.call("bench", times);
            double taken = System.nanoTime() - start;
            first = first == null ? process.result() : first;
            Disagreement.check(Language.URBISCRIPT, first, language, process.result());
            samples.computeIfAbsent(language, key -> new ArrayList<>()).add(taken);
          }
        }
      }
    } catch (IOException | LanguageProcess.Failure | Disagreement e) {
      return Result.failed(row.program(), row.title(), String.valueOf(e.getMessage()));
    }
    Map<Language, Double> figures = new EnumMap<>(Language.class);
    samples.forEach((language, taken) -> figures.put(language, Comparison.median(taken)));
    return new Result(
        row.program(), row.title(), Unit.TIME, figures, samples, new Target.None(), "");
  }

  private int timesFor(Row row) throws IOException, LanguageProcess.Failure {
    Optional<LanguageProcess> python =
        LanguageProcess.start(machine, Language.PYTHON, row.program(), "");
    if (python.isEmpty()) {
      throw new LanguageProcess.Failure("CPython, which tells how much work it is, is missing");
    }
    try (LanguageProcess process = python.get()) {
      int times = 1;
      long taken = process.call("bench", times);
      while (taken < CALIBRATION && times < MAX_TIMES) {
        times *= 2;
        taken = process.call("bench", times);
      }
      return (int) Math.max(1, Math.round((double) work * times / taken));
    }
  }
}
