package org.urbi.bench.crossing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Kernel;

/**
 * Calls, notifications and images between urbiscript and C++, beside bare JNA calls and callbacks:
 * all in one run, in turns, and printed as ratios. Arguments: the headers, the source, and for how
 * many rounds.
 */
public final class Crossings {
  private static final int TURN_NANOSECONDS = 60_000_000;
  private static final int WARM_UP_ROUNDS = 40;
  private static final int ROUNDS = 15;

  /** Something that is measured, less something else. */
  private record Item(String name, IntConsumer turns, @Nullable IntConsumer less) {
    Item(String name, IntConsumer turns) {
      this(name, turns, null);
    }
  }

  private record Target(int item, int base, double most) {}

  private Crossings() {}

  /** Measures, prints, and exits with 1 if a target is missed. */
  public static void main(String[] args) throws IOException, InterruptedException {
    Path library = compile(args[0], args[1]);
    int rounds = args.length > 2 ? Integer.parseInt(args[2]) : ROUNDS;
    BareCalls.map(library);
    boolean met;
    try (Kernel kernel = Kernel.builder().start()) {
      kernel.eval("loadModule(\"" + library + "\")");
      kernel.eval(
          """
          Crossings.&image >> Crossings.&input|
          function Global.empty(n) { var i = 0| while| (i < n) { i += 1 } };
          function Global.calls(n) { var i = 0| while| (i < n) { Crossings.next(1)| i += 1 } };
          function Global.changes(n) { var i = 0| while| (i < n) { Crossings.watched = 1| i += 1 } };
          """);
      Object same = kernel.eval("Crossings.images(10)");
      if (!Double.valueOf(10).equals(same)) {
        throw new IllegalStateException("images were copied: " + same + " of 10 were not");
      }
      IntConsumer empty = n -> kernel.call("empty", n);
      List<Item> items =
          List.of(
              new Item("bare direct call", BareCalls::calls),
              new Item("bare callback", BareCalls::callbacks),
              new Item("call urbiscript -> C++ -> urbiscript", n -> kernel.call("calls", n), empty),
              new Item("notify-change of C++", n -> kernel.call("changes", n), empty),
              new Item(
                  "640x480 image in bypass mode", n -> kernel.eval("Crossings.images(" + n + ")")));
      List<Target> targets =
          List.of(new Target(2, 0, 6), new Target(3, 1, 4), new Target(4, 0, 10));
      met = print(items, targets, measure(items, rounds));
    }
    System.exit(met ? 0 : 1);
  }

  private static Path compile(String headers, String source)
      throws IOException, InterruptedException {
    Path library = Files.createTempDirectory("urbi-bench").resolve("crossings.so");
    int status =
        new ProcessBuilder(
                "g++",
                "-std=c++17",
                "-O2",
                "-I",
                headers,
                "-fPIC",
                "-shared",
                source,
                "-o",
                library.toString())
            .inheritIO()
            .start()
            .waitFor();
    if (status != 0) {
      throw new IllegalStateException("cannot compile " + source);
    }
    return library;
  }

  /** The median of the nanoseconds of each item. */
  private static double[] measure(List<Item> items, int rounds) {
    int[] counts = new int[items.size()];
    List<double[]> samples = new ArrayList<>();
    for (int i = 0; i < counts.length; i++) {
      counts[i] = 1000;
      samples.add(new double[rounds]);
    }
    for (int round = -WARM_UP_ROUNDS; round < rounds; round++) {
      for (int i = 0; i < counts.length; i++) {
        Item item = items.get(i);
        long time = time(item.turns, counts[i]);
        double rest = item.less == null ? 0 : time(item.less, counts[i]);
        if (round >= 0) {
          samples.get(i)[round] = (time - rest) / counts[i];
        } else {
          counts[i] = (int) Math.clamp((double) TURN_NANOSECONDS * counts[i] / time, 100, 1e8);
        }
      }
    }
    return samples.stream().mapToDouble(Crossings::median).toArray();
  }

  private static long time(IntConsumer turns, int count) {
    long start = System.nanoTime();
    turns.accept(count);
    return System.nanoTime() - start;
  }

  private static double median(double... samples) {
    double[] sorted = samples.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  private static boolean print(List<Item> items, List<Target> targets, double... nanoseconds) {
    boolean met = true;
    System.out.printf(Locale.ROOT, "%-40s %10s  %s%n", "", "ns", "");
    for (int i = 0; i < items.size(); i++) {
      String compared = "";
      for (Target target : targets) {
        if (target.item == i) {
          double ratio = nanoseconds[i] / nanoseconds[target.base];
          met &= ratio <= target.most;
          compared =
              String.format(
                  Locale.ROOT,
                  "%.1f times a %s, at most %.0f: %s",
                  ratio,
                  items.get(target.base).name,
                  target.most,
                  ratio <= target.most ? "met" : "MISSED");
        }
      }
      System.out.printf(
          Locale.ROOT, "%-40s %10.0f  %s%n", items.get(i).name, nanoseconds[i], compared);
    }
    return met;
  }
}
