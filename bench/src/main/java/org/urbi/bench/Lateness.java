package org.urbi.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;

/** How late the periods of a loop of 10 ms begin, and how long a loop is kept waiting. */
public final class Lateness {
  private static final String NAME = "lateness";

  /** Of the loop, in nanoseconds. */
  public static final long PERIOD = 10_000_000;

  private static final List<Integer> SLEEPERS = List.of(0, 10_000, 1_000_000);
  private static final Target NONE = new Target.None();

  private final Installation machine;
  private final int seconds;

  Lateness(Installation machine, int seconds) {
    this.machine = machine;
    this.seconds = seconds;
  }

  /** Rows of lateness, alone and beside a job that never rests; then of pauses. */
  List<Result> run() {
    List<Result> results = new ArrayList<>();
    try {
      results.addAll(lateness("every(10ms), idle", false));
      results.addAll(lateness("every(10ms), beside a spinning job", true));
      for (int sleepers : SLEEPERS) {
        results.add(pause(sleepers));
      }
    } catch (IOException | LanguageProcess.Failure e) {
      results.add(Result.failed(NAME, NAME, String.valueOf(e.getMessage())));
    }
    return results;
  }

  private List<Result> lateness(String title, boolean spinning)
      throws IOException, LanguageProcess.Failure {
    double[] bare = late(bareLoop());
    String answer = evaluate("periods(%ds, %s);".formatted(seconds, spinning));
    double[] own =
        late(Stream.of(answer.split(" ")).mapToDouble(text -> 1e9 * Double.parseDouble(text)));
    List<Result> results = new ArrayList<>();
    for (double share : new double[] {0.5, 0.99, 0.999}) {
      Map<Language, Double> figures = new EnumMap<>(Language.class);
      figures.put(Language.URBISCRIPT, at(own, share));
      figures.put(Language.BARE, at(bare, share));
      String row = title + ", p" + (share * 100 + "").replaceFirst("\\.0$", "");
      results.add(new Result(NAME, row, Unit.TIME, figures, Map.of(), NONE, ""));
    }
    return results;
  }

  private Result pause(int sleepers) throws IOException, LanguageProcess.Failure {
    double seconds = Double.parseDouble(evaluate("longestPause(%d, 5s);".formatted(sleepers)));
    return new Result(
        NAME,
        "longest pause, %,d asleep".formatted(sleepers),
        Unit.TIME,
        Map.of(Language.URBISCRIPT, seconds * 1e9),
        Map.of(),
        NONE,
        "");
  }

  private String evaluate(String code) throws IOException, LanguageProcess.Failure {
    try (LanguageProcess process =
        LanguageProcess.start(machine, Language.URBISCRIPT, NAME, "").orElseThrow()) {
      return process.evaluate(code);
    }
  }

  /** When a thread that does nothing else wakes up, in nanoseconds. */
  private java.util.stream.DoubleStream bareLoop() {
    double[] moments = new double[(int) (seconds * 1_000_000_000L / PERIOD)];
    long start = System.nanoTime();
    for (int i = 0; i < moments.length; i++) {
      long deadline = start + i * PERIOD;
      for (long left = deadline - System.nanoTime();
          left > 0;
          left = deadline - System.nanoTime()) {
        LockSupport.parkNanos(left);
      }
      moments[i] = System.nanoTime();
    }
    return Arrays.stream(moments);
  }

  /**
   * How much later than its deadline each period began, sorted. The deadlines are a fixed grid;
   * where it lies is told by the periods that began earliest.
   *
   * @param moments when they began, one after the other, in nanoseconds since any moment
   */
  public static double[] late(java.util.stream.DoubleStream moments) {
    double[] late = moments.toArray();
    for (int i = 0; i < late.length; i++) {
      late[i] -= (double) i * PERIOD;
    }
    double earliest = Arrays.stream(late).min().orElse(0);
    return Arrays.stream(late).map(value -> value - earliest).sorted().toArray();
  }

  /** The value that so large a share of them does not exceed. */
  public static double at(double[] sorted, double share) {
    return sorted[
        (int) Math.min(sorted.length - 1L, Math.round(Math.ceil(share * sorted.length)) - 1)];
  }
}
