package org.urbi.bench;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/** Runs the same programs in urbiscript, Python and Lua, and prints how they compare. */
public final class WholePrograms {
  private static final int STARTUP_RUNS = 21;
  private static final long TENTH = 100_000_000;
  private static final long WHOLE = 1_000_000_000;
  private static final int LATENESS_SECONDS = 20;
  private static final int GROWTH_ROUNDS = 5;

  /** The geometric mean of the everyday programs: twice as fast as Lua. */
  private static final Target MEAN = new Target.Ratio(Language.LUA, 0.5);

  private static final Target FRESH_MEAN = new Target.Ratio(Language.PYTHON, 1.5);
  private static final Target NONE = new Target.None();

  /** What is measured besides programs. */
  private static final List<String> OTHERS =
      List.of("sleepers", "wake-ups", "startup", "fresh", "lateness", "growth");

  private final Installation machine = new Installation();
  private final PrintStream progress = System.err;
  private final Set<String> only;
  private final boolean quick;
  private final boolean profile;

  private WholePrograms(Arguments arguments) {
    only = new LinkedHashSet<>(arguments.rest());
    quick = arguments.has("--quick");
    profile = arguments.has("--profile");
  }

  public static void main(String[] args) {
    Program program =
        new Program("bench/run", "Runs the same programs side by side in urbiscript, Python, Lua.")
            .arguments("NAME...", "Run only these programs (default: all of them).")
            .option("FILE", "Write the results to FILE, too, samples included.", "--json")
            .flag("A rough look: shorter warm-up, fewer samples.", "--quick")
            .flag("Run urbiscript alone, and print where the time goes.", "--profile")
            .flag("Write docs/benchmarks.md, too: all programs, on a calm machine.", "--document")
            .flag("List the names of the programs.", "--list");
    System.exit(
        program.run(args, System.out, System.err, given -> new WholePrograms(given).start(given)));
  }

  private int start(Arguments arguments) {
    List<String> names =
        Stream.concat(
                Stream.concat(Row.constructs().stream(), Row.everyday().stream()).map(Row::program),
                OTHERS.stream())
            .toList();
    if (arguments.has("--list")) {
      names.forEach(System.out::println);
      return 0;
    }
    for (String name : only) {
      if (!names.contains(name)) {
        throw Failure.usage("no such program: " + name + " (there are: " + names + ")");
      }
    }
    boolean document = arguments.has("--document");
    if (document && (quick || profile || !only.isEmpty())) {
      throw Failure.usage("--document wants everything, measured thoroughly");
    }
    if (document && !Load.becomesCalm(progress)) {
      throw Failure.of(
          "the machine is busy (" + Load.text() + "): its figures are not for docs/benchmarks.md");
    }
    List<String> description = machine.description();
    description.forEach(progress::println);
    try {
      List<Section> sections = measure();
      for (Section section : sections) {
        section.print(System.out);
        System.out.println();
      }
      List<Result> results = sections.stream().flatMap(part -> part.results().stream()).toList();
      String file = arguments.value("--json");
      if (file != null) {
        Files.writeString(Path.of(file), Json.of(description, results));
      }
      if (document) {
        new Document(machine.root()).write(description, sections);
      }
      return results.stream().anyMatch(Result::isFailure) ? 1 : 0;
    } catch (IOException e) {
      throw Failure.of(String.valueOf(e.getMessage()));
    }
  }

  private List<Section> measure() throws IOException {
    List<Section> sections = new ArrayList<>();
    List<Result> constructs = rows(Row.constructs(), this::warm);
    if (wanted("sleepers")) {
      progress.println("sleepers ...");
      constructs.addAll(new SleepingJobs(machine).run(""));
    }
    if (wanted("wake-ups")) {
      progress.println("wake-ups ...");
      constructs.addAll(new WakeUps(machine).run());
    }
    if (wanted("startup")) {
      constructs.addAll(new Startup(machine, progress).run(quick ? 5 : STARTUP_RUNS));
    }
    sections.add(new Section("Single constructs, warm", constructs));
    sections.add(
        new Section("Everyday programs, warm", rows(Row.everyday(), this::warm)).withMean(MEAN));
    if (wanted("fresh")) {
      sections.add(fresh("0.1 s", TENTH));
      sections.add(fresh("1 s", WHOLE));
    }
    if (wanted("lateness")) {
      progress.println("lateness ...");
      int seconds = quick ? LATENESS_SECONDS / 4 : LATENESS_SECONDS;
      sections.add(new Section("Punctuality", new Lateness(machine, seconds).run()));
    }
    if (wanted("growth")) {
      progress.println("growth ...");
      int rounds = quick ? 2 : GROWTH_ROUNDS;
      sections.add(
          new Section("Growth of the time for n of them", new Growth(machine, rounds).run()));
    }
    sections.removeIf(part -> part.results().isEmpty());
    return sections;
  }

  /** With the name of "fresh", the programs that are named besides, or all of them. */
  private Section fresh(String work, long nanoseconds) {
    var processes = new FreshProcesses(machine, nanoseconds, quick ? 1 : 3);
    List<Result> results = new ArrayList<>();
    List<Row> some = Row.everyday().stream().filter(row -> only.contains(row.program())).toList();
    for (Row row : some.isEmpty() ? Row.everyday() : some) {
      progress.println(row.program() + ", fresh, " + work + " ...");
      results.add(processes.run(row));
    }
    String title = "Everyday programs, fresh process, " + work + " of CPython's work";
    return new Section(title, results).withMean(nanoseconds == TENTH ? FRESH_MEAN : NONE);
  }

  private List<Result> rows(List<Row> rows, Function<Row, Result> measure) {
    List<Result> results = new ArrayList<>();
    for (Row row : rows) {
      if (only.isEmpty() || only.contains(row.program())) {
        progress.println(row.program() + " ...");
        results.add(measure.apply(row));
      }
    }
    return results;
  }

  private boolean wanted(String name) {
    return !profile && (only.isEmpty() || only.contains(name));
  }

  private Result warm(Row row) {
    return profile
        ? record(row)
        : new Comparison(
                machine, quick ? Comparison.Thoroughness.QUICK : Comparison.Thoroughness.THOROUGH)
            .run(row, "");
  }

  private Result record(Row row) {
    try {
      FlightRecording recording = new FlightRecording(machine, row.program());
      Result result =
          new Comparison(machine, Comparison.Thoroughness.RECORDED)
              .run(row.alone(), recording.options());
      System.out.println("== " + row.program());
      recording.print(System.out);
      return result;
    } catch (IOException e) {
      return Result.failed(row.program(), row.title(), String.valueOf(e.getMessage()));
    }
  }
}
