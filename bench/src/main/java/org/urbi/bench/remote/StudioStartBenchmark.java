package org.urbi.bench.remote;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * How long it takes from going to the studio to the first lines of jobs, as Chromium itself counts
 * it: with nothing kept of the page, and again with what it has kept. It needs chromium and
 * chromedriver.
 */
public final class StudioStartBenchmark {
  private static final int ROUNDS = 7;

  /** How long it may take, in milliseconds. */
  private static final int MOST = 1000;

  private static final String SHOWN = "document.querySelector('#list')?.dataset.since ?? ''";

  private StudioStartBenchmark() {}

  /** Goes to a page, and returns after how many milliseconds it showed jobs. */
  private static int open(Chromium browser, String page) throws IOException, InterruptedException {
    browser.open(page);
    return Integer.parseInt(browser.await(SHOWN));
  }

  /** Prints the median of all times, and returns whether it is as promised. */
  private static boolean print(String title, List<Integer> all) {
    List<Integer> sorted = all.stream().sorted().toList();
    int median = sorted.get(sorted.size() / 2);
    System.out.printf(
        Locale.ROOT,
        "%-32s %5d ms (%d to %d)  %s%n",
        title,
        median,
        sorted.getFirst(),
        sorted.getLast(),
        median <= MOST ? "met" : "MISSED: at most " + MOST + " ms");
    return median <= MOST;
  }

  private static boolean measure(Chromium browser, String page)
      throws IOException, InterruptedException {
    List<Integer> first = new ArrayList<>();
    List<Integer> again = new ArrayList<>();
    open(browser, page);
    for (int round = 0; round < ROUNDS; round++) {
      browser.forget();
      first.add(open(browser, page));
      again.add(open(browser, page));
    }
    return print("first jobs, nothing kept", first) & print("first jobs, the page is kept", again);
  }

  /** Measures it, and returns whether it is as promised. */
  static boolean run(Path root) throws IOException, InterruptedException {
    String urbi = root.resolve("urbi").toString();
    Process server =
        new ProcessBuilder(urbi, "-q", "-i", "--studio=0", "-e", "every (10ms) { 1 },")
            .redirectErrorStream(true)
            .start();
    try (Chromium browser = new Chromium()) {
      return measure(browser, Chromium.await(server.getInputStream(), "studio: (http\\S+)"));
    } finally {
      server.destroy();
      server.waitFor();
    }
  }

  public static void main(String[] arguments) throws Exception {
    System.exit(run(Path.of(System.getProperty("bench.root"))) ? 0 : 1);
  }
}
