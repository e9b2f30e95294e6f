package org.urbi.kernel;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.trust.Role;
import org.urbi.lang.parse.UrbiParser;

/** Runs random programs, each batch of them in two kernels that must say the same. */
final class ProgramFuzzer {
  /** So many programs have a kernel in common. */
  static final int BATCH = 40;

  private final Path directory;
  private final WrongValues values;
  private final Role role;
  private int programs;
  private int interrupted;
  private int exhausted;

  ProgramFuzzer(Path directory, Role role) {
    this.directory = directory;
    this.role = role;
    this.values = new WrongValues();
    try (WrongCallKernel kernel = new WrongCallKernel(directory)) {
      kernel.teach(values);
    }
  }

  /** How many programs were run, all of them twice. */
  int programs() {
    return programs;
  }

  /** How many of them were ended because they took too long. */
  int interrupted() {
    return interrupted;
  }

  /** How many of them have filled the memory. */
  int exhausted() {
    return exhausted;
  }

  /** Runs the programs of that seed; what is wrong with them, or null. */
  @Nullable String defect(long seed) {
    RandomProgram source = new RandomProgram(new SplittableRandom(seed), values);
    List<Program> batch = new ArrayList<>();
    for (int i = 0; i < BATCH; i++) {
      Program program = source.next();
      String wrong = syntaxError(program);
      if (wrong != null) {
        return "seed "
            + seed
            + ": a program that is not well-formed: "
            + wrong
            + "\n"
            + program.text();
      }
      batch.add(program);
    }
    Finding found = find(batch);
    return found == null ? null : "seed " + seed + ": " + explained(batch, found);
  }

  private static @Nullable String syntaxError(Program program) {
    var errors = UrbiParser.parse(program.text(), null).errors();
    return errors.isEmpty() ? null : errors.getFirst().message();
  }

  /**
   * A defect.
   *
   * @param index of the program that shows it
   */
  private record Finding(int index, String kind, String text) {}

  /** The first defect of programs that run one after the other. */
  private @Nullable Finding find(List<Program> batch) {
    List<String> texts = batch.stream().map(Program::text).toList();
    List<ProgramKernel.Outcome> first = outcomes(texts);
    programs += first.size();
    int last = first.size() - 1;
    ProgramKernel.Outcome end = first.get(last);
    if (end.defect() != null) {
      return new Finding(last, end.defect(), end.output());
    }
    interrupted += end.interrupted() ? 1 : 0;
    exhausted += (int) first.stream().filter(ProgramKernel.Outcome::exhausted).count();
    List<ProgramKernel.Outcome> second = outcomes(texts.subList(0, comparable(first)));
    int compared = comparable(second);
    for (int i = 0; i < compared; i++) {
      String difference = difference(first.get(i).output(), second.get(i).output());
      if (difference != null) {
        return new Finding(i, "not the same twice", difference);
      }
    }
    return null;
  }

  /** How many programs come before the first one that need not do the same twice. */
  private static int comparable(List<ProgramKernel.Outcome> outcomes) {
    int same = 0;
    while (same < outcomes.size()
        && !outcomes.get(same).interrupted()
        && !outcomes.get(same).exhausted()) {
      same++;
    }
    return same;
  }

  private static @Nullable String difference(String one, String other) {
    if (one.equals(other)) {
      return null;
    }
    int at = 0;
    while (at < Math.min(one.length(), other.length()) && one.charAt(at) == other.charAt(at)) {
      at++;
    }
    int from = Math.max(0, at - 200);
    return one.substring(from, Math.min(one.length(), at + 200))
        + "\n— and —\n"
        + other.substring(from, Math.min(other.length(), at + 200));
  }

  private List<ProgramKernel.Outcome> outcomes(List<String> texts) {
    try (ProgramKernel kernel = new ProgramKernel(directory)) {
      return kernel.run(texts, role);
    }
  }

  private String explained(List<Program> batch, Finding found) {
    Program program = batch.get(found.index);
    Finding alone = find(List.of(program));
    if (alone == null) {
      return shown(found) + "\nonly after those before it, which end with\n" + program.text();
    }
    Program small =
        program.shrunk(candidate -> {
          if (syntaxError(candidate) != null) {
            return false;
          }
          Finding again = find(List.of(candidate));
          return again != null && again.kind.substring(0, 8).equals(alone.kind.substring(0, 8));
        });
    return shown(find(List.of(small)) instanceof Finding last ? last : alone)
        + "\nof\n"
        + small.text();
  }

  private static String shown(Finding found) {
    String text = found.text;
    return found.kind
        + ":\n"
        + (text.length() < 2_000 ? text : "…" + text.substring(text.length() - 2_000));
  }
}
