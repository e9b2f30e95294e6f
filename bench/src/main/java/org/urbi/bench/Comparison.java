package org.urbi.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Runs one program in all its languages: first each one alone until it gets no faster, then in
 * turns, so that other load on the machine affects all of them equally.
 */
final class Comparison {
  /** How long a sample is at least: long beside the way there and back, which is 0.1 ms. */
  private static final long SAMPLE = 40_000_000;

  private static final int MAX_TIMES = 1 << 20;
  private static final int STABLE = 6;
  private static final double TOLERANCE = 0.04;

  private final Installation machine;
  private final Thoroughness pace;

  /**
   * How thoroughly to measure.
   *
   * @param warmUp how long a program warms up at least, in nanoseconds
   * @param atMost how long it may go on warming up while it still gets faster
   * @param rounds how many samples count
   */
  record Thoroughness(long warmUp, long atMost, int rounds) {
    static final Thoroughness THOROUGH = new Thoroughness(4_000_000_000L, 15_000_000_000L, 15);

    /** For those who want to see where the time goes. */
    static final Thoroughness RECORDED = new Thoroughness(4_000_000_000L, 5_000_000_000L, 150);

    static final Thoroughness QUICK = new Thoroughness(1_000_000_000L, 3_000_000_000L, 5);
  }

  /** A program in one language, with its measurements. */
  private static final class Entry {
    final LanguageProcess languageProcess;
    int times;
    final List<Double> samples = new ArrayList<>();

    Entry(LanguageProcess languageProcess) {
      this.languageProcess = languageProcess;
    }
  }

  Comparison(Installation machine, Thoroughness pace) {
    this.machine = machine;
    this.pace = pace;
  }

  /** Measures one row. What does not work is said in the result. */
  Result run(Row row, String urbiOptions) {
    List<Entry> entries = new ArrayList<>();
    List<String> notes = new ArrayList<>();
    List<Language> languages = new ArrayList<>(List.of(Language.URBISCRIPT));
    languages.addAll(row.languages());
    try {
      for (Language language : languages) {
        try {
          Optional<LanguageProcess> languageProcess =
              LanguageProcess.start(machine, language, row.program(), urbiOptions);
          languageProcess.ifPresent(started -> entries.add(new Entry(started)));
        } catch (LanguageProcess.Failure e) {
          notes.add(language.label() + ": " + e.getMessage());
        }
      }
      perform(row, entries, notes);
    } catch (Disagreement e) {
      return Result.failed(row.program(), row.title(), String.valueOf(e.getMessage()));
    } catch (IOException e) {
      notes.add(String.valueOf(e.getMessage()));
    } finally {
      entries.forEach(entry -> entry.languageProcess.close());
    }
    return result(row, entries, notes);
  }

  private void perform(Row row, List<Entry> entries, List<String> notes) throws Disagreement {
    for (Entry entry : List.copyOf(entries)) {
      attempt(entry, entries, notes, () -> warmUp(row, entry));
    }
    compareResults(entries);
    for (int round = 0; round < pace.rounds(); round++) {
      for (Entry entry : List.copyOf(entries)) {
        attempt(entry, entries, notes, () -> entry.samples.add(sample(row, entry)));
      }
    }
  }

  /** An operation that may fail in one language. */
  private interface Step {
    void take() throws LanguageProcess.Failure;
  }

  private static void attempt(Entry entry, List<Entry> entries, List<String> notes, Step step) {
    try {
      step.take();
    } catch (LanguageProcess.Failure e) {
      notes.add(entry.languageProcess.language().label() + ": " + e.getMessage());
      entry.languageProcess.close();
      entries.remove(entry);
    }
  }

  private void warmUp(Row row, Entry entry) throws LanguageProcess.Failure {
    long start = System.nanoTime();
    entry.times = enough(entry, 1);
    if (!entry.languageProcess.language().warmsUp()) {
      return;
    }
    List<Double> past = new ArrayList<>();
    while (System.nanoTime() - start < pace.atMost()) {
      past.add(sample(row, entry));
      if (System.nanoTime() - start > pace.warmUp() && stable(past)) {
        break;
      }
    }
    entry.times = enough(entry, 1);
  }

  /** How many runs fill a sample. */
  private static int enough(Entry entry, int from) throws LanguageProcess.Failure {
    int times = from;
    while (entry.languageProcess.call("bench", times) < SAMPLE && times < MAX_TIMES) {
      times *= 2;
    }
    return times;
  }

  private static boolean stable(List<Double> past) {
    int size = past.size();
    if (size < 2 * STABLE) {
      return false;
    }
    double before = median(past.subList(size - 2 * STABLE, size - STABLE));
    double after = median(past.subList(size - STABLE, size));
    return after > before * (1 - TOLERANCE);
  }

  /** The time of one operation in nanoseconds. */
  private static double sample(Row row, Entry entry) throws LanguageProcess.Failure {
    double time = entry.languageProcess.call("bench", entry.times);
    if (row.based()) {
      String result = entry.languageProcess.result();
      time -= entry.languageProcess.call("base", entry.times);
      if (!entry.languageProcess.result().equals(result)) {
        throw new LanguageProcess.Failure(
            "bench is " + result + ", base is " + entry.languageProcess.result());
      }
    }
    return time / entry.times / row.operations();
  }

  /** Programs that do the same have the same result, to the last of six decimals. */
  private static void compareResults(List<Entry> entries) throws Disagreement {
    for (Entry entry : entries) {
      LanguageProcess first = entries.getFirst().languageProcess;
      Disagreement.check(
          first.language(),
          first.result(),
          entry.languageProcess.language(),
          entry.languageProcess.result());
    }
  }

  private static Result result(Row row, List<Entry> entries, List<String> notes) {
    Map<Language, Double> figures = new EnumMap<>(Language.class);
    Map<Language, List<Double>> samples = new EnumMap<>(Language.class);
    for (Entry entry : entries) {
      if (!entry.samples.isEmpty()) {
        figures.put(entry.languageProcess.language(), median(entry.samples));
        samples.put(entry.languageProcess.language(), entry.samples);
      }
    }
    return new Result(
        row.program(),
        row.title(),
        Unit.TIME,
        figures,
        samples,
        row.target(),
        String.join("; ", notes));
  }

  /** The middle one. */
  static double median(List<Double> values) {
    List<Double> sorted = new ArrayList<>(values);
    Collections.sort(sorted);
    int half = sorted.size() / 2;
    return sorted.size() % 2 == 1
        ? sorted.get(half)
        : Arrays.asList(sorted.get(half - 1), sorted.get(half)).stream()
            .mapToDouble(Double::doubleValue)
            .average()
            .orElse(0);
  }
}
