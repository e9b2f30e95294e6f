package org.urbi.bench;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.urbi.server.options.Program;

/**
 * How long a cold process takes to say hello: to its first output, and to its end; and if there are
 * two thousand lines before.
 */
public final class Startup {
  private static final int RUNS = 21;
  private static final String URBI = "echo(\"Hello, World!\");";
  private static final Target TARGET = new Target.Ratio(Language.BARE, 3);
  private static final Target LOADED = new Target.Absolute(250e6, Unit.TIME);

  private final Installation machine;
  private final PrintStream progress;

  /** What one run took, in nanoseconds. */
  private record Run(long firstOutput, long total) {}

  /** A command with what it took. */
  private record Candidate(String label, List<String> command, List<Run> runs) {
    Candidate(String label, String... command) {
      this(label, List.of(command), new ArrayList<>());
    }

    double firstOutput() {
      return median(Run::firstOutput);
    }

    double total() {
      return median(Run::total);
    }

    private double median(java.util.function.ToLongFunction<Run> what) {
      return Comparison.median(runs.stream().map(run -> (double) what.applyAsLong(run)).toList());
    }
  }

  Startup(Installation machine, PrintStream progress) {
    this.machine = machine;
    this.progress = progress;
  }

  /** Prints a table of its own. */
  public static void main(String[] args) {
    Program program =
        new Program("bench/startup", "Measures how long Hello, World takes from a cold process.")
            .option("N", "How many runs of each (default: " + RUNS + ").", "--runs");
    System.exit(
        program.run(
            args,
            System.out,
            System.err,
            arguments -> {
              try {
                new Startup(new Installation(), System.err)
                    .print(System.out, arguments.number("--runs", RUNS, 1, 10_000));
                return 0;
              } catch (IOException e) {
                System.err.println("bench/startup: " + e.getMessage());
                return 1;
              }
            }));
  }

  /** The rows of the big table. */
  List<Result> run(int runs) {
    try {
      Map<Language, Candidate> candidates = common();
      measure(List.copyOf(candidates.values()), runs);
      Map<Language, Double> first = new EnumMap<>(Language.class);
      Map<Language, Double> total = new EnumMap<>(Language.class);
      candidates.forEach((language, candidate) -> {
        first.put(language, candidate.firstOutput());
        total.put(language, candidate.total());
      });
      Map<Language, Candidate> loading = loading();
      measure(List.copyOf(loading.values()), runs);
      Map<Language, Double> loaded = new EnumMap<>(Language.class);
      loading.forEach((language, candidate) ->
          loaded.put(language, candidate.total() - total.getOrDefault(language, 0.0)));
      return List.of(
          row("hello: first output", first, new Target.None(), ""),
          row("hello: whole process", total, TARGET, ""),
          row("hello after 2,000 lines: more", loaded, LOADED, ""));
    } catch (IOException e) {
      return List.of(row("hello", Map.of(), TARGET, String.valueOf(e.getMessage())));
    }
  }

  private static Result row(
      String title, Map<Language, Double> figures, Target target, String note) {
    return new Result("startup", title, Unit.TIME, figures, Map.of(), target, note);
  }

  private Map<Language, Candidate> common() throws IOException {
    Map<Language, Candidate> candidates = new EnumMap<>(Language.class);
    candidates.put(
        Language.URBISCRIPT,
        new Candidate("./urbi", machine.urbi(), "-q", "-e", URBI, "-e", "shutdown;"));
    Optional<String> python = machine.interpreter(Language.PYTHON);
    python.ifPresent(path ->
        candidates.put(
            Language.PYTHON, new Candidate("CPython", path, "-c", "print('Hello, World!')")));
    Optional<String> lua = machine.interpreter(Language.LUA);
    lua.ifPresent(path ->
        candidates.put(Language.LUA, new Candidate("Lua", path, "-e", "print('Hello, World!')")));
    candidates.put(
        Language.BARE,
        new Candidate("java Hello", Installation.java(), "-cp", hello().toString(), "Hello"));
    return candidates;
  }

  private Map<Language, Candidate> loading() throws IOException {
    Path folder = Files.createDirectories(machine.results().resolve("hello"));
    Map<Language, Candidate> candidates = new EnumMap<>(Language.class);
    String urbiscript = LongScript.write(folder, Language.URBISCRIPT).toString();
    candidates.put(
        Language.URBISCRIPT, new Candidate("./urbi", machine.urbi(), "-q", "-f", urbiscript));
    for (Language language : List.of(Language.PYTHON, Language.LUA)) {
      String script = LongScript.write(folder, language).toString();
      machine
          .interpreter(language)
          .ifPresent(
              path -> candidates.put(language, new Candidate(language.label(), path, script)));
    }
    return candidates;
  }

  private void print(PrintStream out, int runs) throws IOException {
    Map<String, Candidate> candidates = new LinkedHashMap<>();
    common().values().forEach(candidate -> candidates.put(candidate.label(), candidate));
    String folder = hello().toString();
    for (String flags : List.of("-XX:+UseSerialGC", "-Xshare:off")) {
      String label = "java " + flags + " Hello";
      candidates.put(
          label, new Candidate(label, Installation.java(), flags, "-cp", folder, "Hello"));
    }
    measure(List.copyOf(candidates.values()), runs);
    double bare = total(candidates, "java Hello");
    out.printf("%-32s %14s %14s %16s%n", "", "first output", "whole process", "to java Hello");
    for (Candidate candidate : candidates.values()) {
      out.printf(
          "%-32s %14s %14s %16.2f%n",
          candidate.label(),
          Unit.TIME.text(candidate.firstOutput()),
          Unit.TIME.text(candidate.total()),
          candidate.total() / bare);
    }
    double ratio = total(candidates, "./urbi") / bare;
    out.printf("target <= 3.0: %s%n", ratio <= 3 ? "met" : "MISSED");
  }

  private static double total(Map<String, Candidate> candidates, String label) {
    return requireNonNull(candidates.get(label), label).total();
  }

  /** The folder of a compiled class that says hello and nothing else. */
  private Path hello() throws IOException {
    Path folder = Files.createDirectories(machine.results().resolve("hello"));
    Path source = folder.resolve("Hello.java");
    if (!Files.exists(folder.resolve("Hello.class"))) {
      Files.writeString(
          source,
          """
          public class Hello {
            public static void main(String[] args) {
              System.out.println("Hello, World!");
            }
          }
          """);
      var compiler = javax.tools.ToolProvider.getSystemJavaCompiler();
      if (compiler.run(null, null, null, "-d", folder.toString(), source.toString()) != 0) {
        throw new IOException("cannot compile " + source);
      }
    }
    return folder;
  }

  private void measure(List<Candidate> candidates, int runs) throws IOException {
    // The first of each brings the files into the system's cache.
    for (int i = -1; i < runs; i++) {
      progress.printf("\rstartup %d/%d ", i + 1, runs);
      for (Candidate candidate : candidates) {
        Run run = once(candidate);
        if (i >= 0) {
          candidate.runs().add(run);
        }
      }
    }
    progress.print("\r                    \r");
  }

  private static Run once(Candidate candidate) throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder(candidate.command()).redirectError(ProcessBuilder.Redirect.INHERIT);
    builder.redirectInput(ProcessBuilder.Redirect.from(new java.io.File("/dev/null")));
    long start = System.nanoTime();
    Process process = builder.start();
    try (InputStream output = process.getInputStream()) {
      int first = output.read();
      final long firstOutput = System.nanoTime() - start;
      String text = (char) first + new String(output.readAllBytes());
      int status = process.waitFor();
      long total = System.nanoTime() - start;
      if (status != 0 || !text.contains("Hello, World!")) {
        throw new IOException(candidate.label() + " says: " + text.strip());
      }
      return new Run(firstOutput, total);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }
}
