package org.urbi.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** How late the last of 100,000 jobs runs that have slept until the same moment. */
final class WakeUps {
  private static final String NAME = "wake-ups";
  private static final int WARM_ROUNDS = 3;
  private static final double NANOSECONDS = 1e9;
  private static final Target LIMIT = new Target.Absolute(0.3 * NANOSECONDS, Unit.TIME);

  private final Installation machine;

  WakeUps(Installation machine) {
    this.machine = machine;
  }

  /** Two rows: the first time in a process, and the median of the next ones. */
  List<Result> run() {
    Map<Language, Double> fresh = new EnumMap<>(Language.class);
    Map<Language, Double> warm = new EnumMap<>(Language.class);
    Map<Language, List<Double>> samples = new EnumMap<>(Language.class);
    List<String> notes = new ArrayList<>();
    for (Language language : List.of(Language.URBISCRIPT, Language.PYTHON, Language.LUA)) {
      try {
        Optional<LanguageProcess> started = LanguageProcess.start(machine, language, NAME, "");
        if (started.isEmpty()) {
          continue;
        }
        try (LanguageProcess process = started.get()) {
          fresh.put(language, round(process));
          List<Double> rounds = new ArrayList<>();
          for (int i = 0; i < WARM_ROUNDS; i++) {
            rounds.add(round(process));
          }
          samples.put(language, rounds);
          warm.put(language, rounds.stream().sorted().toList().get(WARM_ROUNDS / 2));
        }
      } catch (IOException | LanguageProcess.Failure e) {
        notes.add(language.label() + ": " + e.getMessage());
      }
    }
    String note = String.join("; ", notes);
    return List.of(
        new Result(NAME, "1e5 wake up, first time", Unit.TIME, fresh, Map.of(), LIMIT, note),
        new Result(NAME, "1e5 wake up, warm", Unit.TIME, warm, samples, LIMIT, note));
  }

  /** The program measures from the moment on: neither the starts nor the sleep count. */
  private static double round(LanguageProcess process) throws LanguageProcess.Failure {
    process.call("bench", 1);
    try {
      return NANOSECONDS * Double.parseDouble(process.result());
    } catch (NumberFormatException e) {
      throw new LanguageProcess.Failure(process.result());
    }
  }
}
