package org.urbi.bench.remote;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import org.urbi.bench.Lateness;

/**
 * Whether the page of the studio stays smooth with 10,000 jobs in its list: the time from each
 * picture to the next one while somebody scrolls through all of them, by the clock of the page. It
 * needs chromium and chromedriver, and without graphics hardware it draws with the processor.
 */
public final class StudioFramesBenchmark {
  private static final int JOBS = 10_000;

  /** How much of the time one in a hundred pictures may take, in milliseconds. */
  private static final double MOST = 50;

  private static final String LISTED =
      "Number(document.querySelector('#count').textContent.replaceAll(',', '')) >= "
          + JOBS
          + " ? 'all' : ''";

  /** Scrolls for ten seconds, down and up, and keeps the times between pictures. */
  private static final String SCROLL =
      "(window.times = [], window.measured = '', requestAnimationFrame(function begin(start) {"
          + "  const list = document.querySelector('#list'); let last = start; let step = 150;"
          + "  requestAnimationFrame(function next(now) {"
          + "    times.push(now - last); last = now;"
          + "    if (list.scrollTop + list.clientHeight >= list.scrollHeight - 1) step = -150;"
          + "    if (list.scrollTop <= 0) step = 150;"
          + "    list.scrollTop += step;"
          + "    if (now < start + 10000) requestAnimationFrame(next); else measured = times.join(' ');"
          + "  });"
          + "}), 'begun')";

  private StudioFramesBenchmark() {}

  /** Prints how long pictures take, and returns whether that is as promised. */
  private static boolean measure(Chromium browser, String title)
      throws IOException, InterruptedException {
    browser.await(SCROLL.replace("\n", " "));
    double[] times =
        Arrays.stream(browser.await("window.measured").split(" "))
            .mapToDouble(Double::parseDouble)
            .sorted()
            .toArray();
    double mostly = Lateness.at(times, 0.99);
    System.out.printf(
        Locale.ROOT,
        "%-32s p50 %5.1f ms, p99 %5.1f ms, longest %5.1f ms of %d  %s%n",
        title,
        Lateness.at(times, 0.5),
        mostly,
        times[times.length - 1],
        times.length,
        mostly <= MOST ? "met" : "MISSED: p99 at most " + MOST + " ms");
    return mostly <= MOST;
  }

  /** Measures it, and returns whether it is as promised. */
  static boolean run(Path root) throws IOException, InterruptedException {
    try (StudioProbe server = new StudioProbe(root, "--studio=0");
        Chromium browser = new Chromium()) {
      String line = server.await("studio: http");
      server.await("ready");
      browser.open(line.substring(line.indexOf("http")).strip());
      browser.await(LISTED);
      boolean met = measure(browser, "frames, jobs asleep");
      server.say("coming: every (20ms) sleep(2s),");
      met &= measure(browser, "frames, jobs that come and go");
      browser.await(
          "(document.querySelector('#order').value = 'share',"
              + " document.querySelector('#order').dispatchEvent(new Event('change')), 'set')");
      return met & measure(browser, "frames, busiest first");
    }
  }

  public static void main(String[] arguments) throws Exception {
    System.exit(run(Path.of(System.getProperty("bench.root"))) ? 0 : 1);
  }
}
