package org.urbi.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** How much memory 100,000 sleeping jobs take. */
final class SleepingJobs {
  private static final String NAME = "sleepers";
  private static final double LIMIT = 400e6;

  private final Installation machine;

  SleepingJobs(Installation machine) {
    this.machine = machine;
  }

  /**
   * Two rows: the heap that is in use after a collection, on which the stacks of sleeping jobs are
   * as well, and what the system counts for the whole process.
   */
  List<Result> run(String urbiOptions) {
    Map<Language, Double> heap = new EnumMap<>(Language.class);
    Map<Language, Double> resident = new EnumMap<>(Language.class);
    List<String> notes = new ArrayList<>();
    for (Language language : List.of(Language.URBISCRIPT, Language.PYTHON, Language.LUA)) {
      try {
        measure(language, urbiOptions, heap, resident);
      } catch (IOException | LanguageProcess.Failure e) {
        notes.add(language.label() + ": " + e.getMessage());
      }
    }
    Target target = new Target.Absolute(LIMIT, Unit.MEMORY);
    String note = String.join("; ", notes);
    return List.of(
        new Result(NAME, "1e5 asleep: heap", Unit.MEMORY, heap, Map.of(), target, note),
        new Result(NAME, "1e5 asleep: resident", Unit.MEMORY, resident, Map.of(), target, note));
  }

  private void measure(
      Language language, String options, Map<Language, Double> heap, Map<Language, Double> resident)
      throws IOException, LanguageProcess.Failure {
    Optional<LanguageProcess> started = LanguageProcess.start(machine, language, NAME, options);
    if (started.isEmpty()) {
      return;
    }
    try (LanguageProcess languageProcess = started.get()) {
      languageProcess.call("bench", 1);
      if (language == Language.URBISCRIPT) {
        var memory = new JavaProcess(languageProcess.pid());
        long before = memory.usedHeap();
        long residentBefore = languageProcess.residentBytes();
        languageProcess.evaluate("putToBed(),\nsleep(1s) | \"asleep\";");
        heap.put(language, (double) (memory.usedHeap() - before));
        put(resident, language, residentBefore, languageProcess.residentBytes());
      } else {
        long before = languageProcess.residentBytes();
        languageProcess.call("putToBed", 1);
        put(resident, language, before, languageProcess.residentBytes());
      }
    }
  }

  private static void put(
      Map<Language, Double> figures, Language language, long before, long after) {
    if (before >= 0 && after >= 0) {
      figures.put(language, (double) (after - before));
    }
  }
}
