package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.StudioPage.line;
import static org.urbi.tests.process.StudioPage.value;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The plot of the studio, in a real browser whose window changes: it shows what it has shown. */
class StudioPlotTest {
  private static final char HOME = '\ue011';

  private static final String PROGRAM =
      """
      var Global.x = 0|; var Global.y = 100|;
      counting: every (20ms) Global.x = (x + 1) % 50,
      """;

  private static final String AREA = "document.querySelector('#plot-area')";
  private static final String SCALE =
      "return " + AREA + ".dataset.from + ' ' + " + AREA + ".dataset.to";
  private static final String ZOOMED = "return " + AREA + ".dataset.zoomed";
  private static final String POINTS = "return Number(" + AREA + ".dataset.points)";

  /** Whether it is as wide as its place. */
  private static final String FITS =
      "return "
          + AREA
          + ".clientWidth > 0 && "
          + AREA
          + ".querySelector('.u-wrap').offsetWidth === "
          + AREA
          + ".clientWidth";

  @Test
  void plotStaysAsItIs(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "#variables")) {
      Browser browser = page.browser();
      try {
        browser.await("a slot", value("Global .y"), "100"::equals);
        plot(browser, "x");
        awaitPoints(browser, 20);
        zoomsAsFarAsItGoes(browser);
        String zoomed = zooms(browser);
        plot(browser, "y");
        stays(browser, zoomed, "with one more number");
        assertEquals("true", browser.evaluate(ZOOMED));
        browser.becomeScreen(1000, 700);
        browser.await("its new width", FITS, "true"::equals);
        stays(browser, zoomed, "in another window");
        browser.evaluate("document.querySelector('#theme').click()");
        stays(browser, zoomed, "in other colours");
        isTurnedInAnotherRoom(browser);
        stays(browser, zoomed, "on a telephone");
        browser.evaluate("document.querySelectorAll('#plotted button')[1].click()");
        stays(browser, zoomed, "with one number less");
        goesOn(browser, zoomed);
        pauses(browser);
        followsTheSystem(browser);
      } finally {
        browser.preferColours("");
        browser.becomeUsual();
      }
      assertTrue(!page.urbi().text().contains("internal error"), page.urbi()::text);
    }
  }

  private static void plot(Browser browser, String slot) throws Exception {
    browser.evaluate(line("Global ." + slot) + ".click()");
    String can = "return document.querySelector('#slot-plot').disabled";
    browser.await("that it can be plotted", can, "false"::equals);
    browser.evaluate("document.querySelector('#slot-plot').click()");
    String shown = StudioPage.text("#plotted");
    browser.await("what is plotted", shown, text -> text.contains("Global." + slot));
  }

  private static void awaitPoints(Browser browser, int more) throws Exception {
    int now = Integer.parseInt(browser.evaluate(POINTS));
    browser.await("later values", POINTS, count -> Integer.parseInt(count) >= now + more);
  }

  /** By a key: what is in sight then is less than before. */
  private static String zooms(Browser browser) throws Exception {
    String before = browser.evaluate(SCALE);
    browser.evaluate(AREA + ".focus()");
    browser.press('+');
    browser.await("that it is zoomed", ZOOMED, "true"::equals);
    awaitPoints(browser, 2);
    String after = browser.evaluate(SCALE);
    assertTrue(end(after, 0) > end(before, 0), before + " -> " + after);
    return after;
  }

  /** What is next to nothing once made the page look for marks at its axis without end. */
  private static void zoomsAsFarAsItGoes(Browser browser) throws Exception {
    browser.evaluate(AREA + ".focus()");
    for (int i = 0; i < 60; i++) {
      browser.press('+');
    }
    browser.await("that it is zoomed", ZOOMED, "true"::equals);
    awaitPoints(browser, 2);
    double seen = width(browser.evaluate(SCALE));
    assertTrue(0.0009 < seen && seen < 0.0011, seen + " seconds");
    browser.press(HOME);
    browser.await("all of it", SCALE, scale -> width(scale) > 0.1);
  }

  private static double end(String scale, int which) {
    return Double.parseDouble(scale.split(" ")[which]);
  }

  private static double width(String scale) {
    return end(scale, 1) - end(scale, 0);
  }

  private static void stays(Browser browser, String scale, String when) throws Exception {
    awaitPoints(browser, 2);
    assertEquals(scale, browser.evaluate(SCALE), when);
  }

  private static void isTurnedInAnotherRoom(Browser browser) throws Exception {
    browser.evaluate("location.hash = 'jobs'");
    String hidden = "return document.querySelector('[data-room=variables]').hidden";
    browser.await("the other room", hidden, "true"::equals);
    browser.becomeTelephone();
    browser.evaluate("location.hash = 'variables'");
    browser.await("the room", hidden, "false"::equals);
    browser.await("its new width", FITS, "true"::equals);
    Fit.checkForFingers(browser, "with its plot");
  }

  /** Also while it stands still. */
  private static void followsTheSystem(Browser browser) throws Exception {
    browser.evaluate(
        "while (document.documentElement.dataset.theme) document.querySelector('#theme').click();"
            + "document.querySelector('#plot-pause').click()");
    String lines =
        """
        const canvas = document.querySelector('#plot-area canvas');
        const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        const pixels = new Set();
        for (let i = 0; i < data.length; i += 4) pixels.add(data.slice(i, i + 4).join(' '));
        return ['223 227 232 255', '44 52 62 255'].filter((line) => pixels.has(line)).join();
        """;
    browser.preferColours("light");
    browser.await("light lines", lines, "223 227 232 255"::equals);
    browser.preferColours("dark");
    browser.await("dark lines", lines, "44 52 62 255"::equals);
  }

  private static void goesOn(Browser browser, String zoomed) throws Exception {
    browser.evaluate(AREA + ".focus()");
    browser.press(HOME);
    browser.await("all of it", SCALE, scale -> width(scale) > width(zoomed) + 0.1);
    assertEquals("false", browser.evaluate(ZOOMED));
  }

  private static void pauses(Browser browser) throws Exception {
    String pause = "document.querySelector('#plot-pause').click()";
    browser.evaluate(pause);
    String paused = browser.evaluate(SCALE);
    plot(browser, "y");
    browser.becomeScreen(1000, 700);
    browser.await("its new width", FITS, "true"::equals);
    assertEquals(paused, browser.evaluate(SCALE));
    browser.evaluate(pause);
    browser.await("the present", SCALE, scale -> width(scale) > width(paused));
  }
}
