package org.urbi.bench;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/** Runs the same programs in urbiscript, Python and Lua, and prints how they compare. */
public final class WholePrograms {
  private static final int STARTUP_RUNS = 21;

  private final Installation machine = new Installation();
  private final PrintStream progress = System.err;
  private final List<Result> results = new ArrayList<>();

  private WholePrograms() {}

  public static void main(String[] args) {
    Set<String> only = new LinkedHashSet<>();
    Program program =
        new Program("bench/run", "Runs the same programs side by side in urbiscript, Python, Lua.")
            .each("NAME", "Run only the program NAME; may be repeated.", only::add, "--only")
            .option("FILE", "Write the results to FILE, too, samples included.", "--json")
            .flag("A rough look: shorter warm-up, fewer samples.", "--quick")
            .flag("Run urbiscript alone, and print where the time goes.", "--profile")
            .flag("List the names of the programs.", "--list");
    System.exit(
        program.run(args, System.out, System.err, given -> new WholePrograms().start(given, only)));
  }

  private int start(Arguments arguments, Set<String> only) {
    List<String> names = new ArrayList<>(Row.all().stream().map(Row::program).toList());
    names.addAll(List.of("sleepers", "startup"));
    if (arguments.has("--list")) {
      names.forEach(System.out::println);
      return 0;
    }
    for (String name : only) {
      if (!names.contains(name)) {
        throw Failure.usage("no such program: " + name + " (there are: " + names + ")");
      }
    }
    boolean quick = arguments.has("--quick");
    List<String> description = machine.description();
    description.forEach(progress::println);
    try {
      for (Row row : Row.all()) {
        if (wanted(only, row.program())) {
          progress.println(row.program() + " ...");
          results.add(arguments.has("--profile") ? record(row) : compare(row, quick));
        }
      }
      if (wanted(only, "sleepers") && !arguments.has("--profile")) {
        progress.println("sleepers ...");
        results.addAll(new SleepingJobs(machine).run(""));
      }
      if (wanted(only, "startup") && !arguments.has("--profile")) {
        results.addAll(new Startup(machine, progress).run(quick ? 5 : STARTUP_RUNS));
      }
      String file = arguments.value("--json");
      if (file != null) {
        Files.writeString(Path.of(file), Json.of(description, results));
      }
    } catch (IOException e) {
      throw Failure.of(String.valueOf(e.getMessage()));
    }
    new Table(results).print(System.out);
    return 0;
  }

  private static boolean wanted(Set<String> only, String name) {
    return only.isEmpty() || only.contains(name);
  }

  private Result compare(Row row, boolean quick) {
    return new Comparison(
            machine, quick ? Comparison.Thoroughness.QUICK : Comparison.Thoroughness.THOROUGH)
        .run(row, "");
  }

  private Result record(Row row) throws IOException {
    FlightRecording recording = new FlightRecording(machine, row.program());
    Result result =
        new Comparison(machine, Comparison.Thoroughness.RECORDED)
            .run(row.alone(), recording.options());
    System.out.println("== " + row.program());
    recording.print(System.out);
    return result;
  }
}
