package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.SimulatedRobot.awaitTruth;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.process.JavaProcess.Setting;

/** All rooms of the studio, in a real browser, by somebody who has nothing but keys. */
class StudioKeyboardTest {
  private static final char TAB = '\ue004';
  private static final char ENTER = '\ue007';
  private static final char END = '\ue010';
  private static final char HOME = '\ue011';
  private static final char DOWN = '\ue015';

  /** More than any room has: who has not come round by then is in a trap. */
  private static final int MOST_STEPS = 80;

  private static final List<String> ROOMS =
      List.of("jobs", "reactions", "variables", "code", "robot");

  private static final String PROGRAM =
      """
      var Global.e = Event.new|;
      var Global.n = 0|;
      reacting: at (e?) n++;
      beating: every (200ms) e!,
      """;

  /** The page, and the one of a simulated world within it. */
  private static final String PAGES =
      """
      const pages = [document, ...[...document.querySelectorAll('iframe')].map((frame) => frame.contentDocument)];
      const all = (selector) => pages.flatMap((page) => [...page.querySelectorAll(selector)]);
      """;

  /** From now on it is noted what has been reached. */
  private static final String BEGIN =
      PAGES
          + """
          for (const page of pages) {
            if (!page.walking) page.addEventListener('focusin', ({target}) => target.walked = true);
            page.walking = true;
          }
          for (const element of all('*')) element.walked = false;
          """;

  private static final String IS_ROUND = "return document.activeElement === document.body";

  /** What was not reached, and what shows that it can be clicked and is nothing for keys. */
  private static final String MISSED =
      PAGES
          + """
          const seen = (element) => element.checkVisibility({visibilityProperty: true});
          const shown = (element) => element.tagName.toLowerCase() + '#' + element.id + '.' + element.className;
          const forKeys = 'button, a[href], select, input, textarea, audio[controls], [tabindex="0"], [contenteditable="true"]';
          const missed = all(forKeys)
            .filter((element) => seen(element) && !element.disabled && element.tabIndex >= 0 && !element.walked)
            .map((element) => 'not reached: ' + shown(element));
          for (const element of all('body *')) {
            const clicked = seen(element) && getComputedStyle(element).cursor === 'pointer';
            if (clicked && !element.closest(forKeys + ', label')) missed.push('only for a pointer: ' + shown(element));
          }
          return missed.join('\\n');
          """;

  private static final String FOCUS = "return document.activeElement.%s";

  private static final String WORLD =
      "document.querySelector('#robot-frame iframe').contentDocument";

  /** What is in the page of the world. */
  private static final String IN_WORLD = "return " + WORLD + ".querySelector('#%s').%s";

  @Test
  void allThatAClickDoesCanBeDoneByKeys(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      browser.await("jobs", "return document.querySelectorAll('.row').length > 2", "true"::equals);
      for (String room : ROOMS) {
        goTo(browser, room);
        walk(browser, room);
        Accessibility.check(browser);
      }
      goesFromTurnToTurn(browser);
      plots(browser);
    }
  }

  @Test
  void worldIsSteeredByKeys(@TempDir Path folder) throws Exception {
    String program =
        """
        requireFile("urbi/sim.u")|;
        var Global.s = Simulation.new("examples/ball-tracking/table.world")|;
        s.showPage(0, nil)|;
        """;
    Setting setting = SimulatedRobot.setting(folder);
    try (StudioPage page = StudioPage.start(setting, Browser.spatial(), folder, program, "")) {
      Browser browser = page.browser();
      String choice = "return !!document.querySelector('nav a[href=\"#robot\"]')";
      browser.await("the rooms", choice, "true"::equals);
      goTo(browser, "robot");
      browser.await(
          "the world",
          "return document.querySelector('#robot-frame iframe')?.contentDocument?.querySelector('#space')?.dataset.time > 0",
          "true"::equals);
      walk(browser, "robot");
      Accessibility.check(browser);
      Accessibility.check(browser, WORLD.replace("document.q", "window.document.q"));
      pushes(browser, page.urbi());
      drives(browser, page.urbi());
    }
  }

  private static void goTo(Browser browser, String room) throws Exception {
    tabTo(browser, FOCUS.formatted("hash"), "#" + room);
    browser.press(ENTER);
    String open =
        "return Boolean(document.querySelector('[data-room=" + room + "]:not([hidden])'))";
    browser.await("the room", open, "true"::equals);
  }

  /** Goes on until something has come. */
  private static void tabTo(Browser browser, String what, String wanted) throws IOException {
    for (int step = 0; step < 2 * MOST_STEPS; step++) {
      if (browser.evaluate(what).equals(wanted)) {
        return;
      }
      browser.press(TAB);
    }
    throw new AssertionError("Tab never comes to " + wanted);
  }

  private static void walk(Browser browser, String room) throws Exception {
    comeRound(browser, room);
    browser.evaluate(BEGIN);
    comeRound(browser, room);
    assertEquals("", browser.evaluate(MISSED), room);
  }

  /** Goes on to the end of the page, behind which it begins again. */
  private static void comeRound(Browser browser, String room) throws IOException {
    int steps = 0;
    do {
      browser.press(TAB);
      assertTrue(++steps < MOST_STEPS, () -> "a trap in the room " + room);
    } while (!browser.evaluate(IS_ROUND).equals("true"));
  }

  private static void goesFromTurnToTurn(Browser browser) throws Exception {
    goTo(browser, "jobs");
    tabTo(browser, FOCUS.formatted("id"), "list");
    browser.press(HOME);
    browser.press(DOWN);
    String beating =
        "return " + StudioPage.row("beating") + "?.getAttribute('aria-selected') === 'true'";
    for (int step = 0; step < MOST_STEPS && !browser.evaluate(beating).equals("true"); step++) {
      browser.press(DOWN);
    }
    String[] told = new String[1];
    browser.await(
        "its turns",
        "return document.querySelector('#job').textContent.includes('Stop')",
        "true"::equals);
    do {
      browser.press(',');
      told[0] = browser.evaluate(StudioPage.text("#turn"));
    } while (!told[0].contains("after it had waited for time"));
    assertTrue(told[0].matches("shell_\\d+: ran for [0-9.]+ ms, [0-9.]+ s ago, .*"), told[0]);
  }

  private static void tabToInWorld(Browser browser, String what, String wanted) throws IOException {
    tabTo(browser, "return " + WORLD + ".activeElement." + what, wanted);
  }

  /** Picks the ball, halts, pushes it, and makes a step; goes back, and makes time go faster. */
  private static void pushes(Browser browser, JavaProcess urbi) throws Exception {
    tabToInWorld(browser, "id", "pause");
    browser.press(ENTER);
    browser.await("the halt", IN_WORLD.formatted("pause", "ariaPressed"), "true"::equals);
    tabToInWorld(browser, "id", "space");
    String picked = IN_WORLD.formatted("space", "dataset.picked");
    for (int step = 0; step < MOST_STEPS && !browser.evaluate(picked).equals("ball"); step++) {
      browser.press('n');
    }
    String told = IN_WORLD.formatted("picked", "textContent");
    assertTrue(browser.evaluate(told).matches("ball( -?[0-9.]+){3}"), browser.evaluate(told));
    tabToInWorld(browser, "id", "strength");
    browser.press(END);
    tabToInWorld(browser, "id", "push");
    browser.press(ENTER);
    tabToInWorld(browser, "id", "step");
    String shown = IN_WORLD.formatted("space", "dataset.time");
    String halted = browser.evaluate(shown);
    browser.press(ENTER);
    browser.await("a step", shown, now -> !now.equals(halted));
    String velocity = "s.world.velocity(\"ball\")[0].abs + s.world.velocity(\"ball\")[1].abs";
    awaitTruth(urbi, "pushed", velocity + " > 2.5");
    tabToInWorld(browser, "id", "reset");
    browser.press(ENTER);
    awaitTruth(urbi, "reset", "s.world.position(\"ball\")[0] == 1.5");
    tabToInWorld(browser, "id", "pace");
    browser.press(DOWN);
    awaitTruth(urbi, "faster", "s.world.speed == 2");
    tabToInWorld(browser, "id", "pause");
    browser.press(ENTER);
    browser.await("that it goes on", IN_WORLD.formatted("pause", "ariaPressed"), "false"::equals);
  }

  /** By letters, of which one is let go as a capital one, and by the buttons. */
  private static void drives(Browser browser, JavaProcess urbi) throws Exception {
    String speed = "s.robot.body.wheel[left].val";
    tabToInWorld(browser, "id", "space");
    browser.hold("w");
    awaitTruth(urbi, "driven", speed + " > 2");
    browser.hold("Shift");
    browser.letGo("W");
    browser.letGo("Shift");
    awaitTruth(urbi, "let go", speed + ".abs < 0.1");
    tabToInWorld(browser, "dataset.drive", "-1 0");
    browser.hold("Enter");
    awaitTruth(urbi, "driven back", speed + " < -2");
    browser.letGo("Enter");
    awaitTruth(urbi, "let go again", speed + ".abs < 0.1");
  }

  private static void plots(Browser browser) throws Exception {
    goTo(browser, "variables");
    tabTo(browser, FOCUS.formatted("id"), "variable-tree");
    browser.press(HOME);
    String selected =
        "return document.querySelector('.line[aria-selected=true]')?.dataset.way.endsWith('.n')";
    for (int step = 0; step < MOST_STEPS && !browser.evaluate(selected).equals("true"); step++) {
      browser.press(DOWN);
    }
    browser.press('p');
    browser.await(
        "the plot", "return !document.querySelector('#plot-area').hidden", "true"::equals);
    tabTo(browser, FOCUS.formatted("id"), "plot-area");
    String zoomed = "return document.querySelector('#plot-area').dataset.zoomed";
    browser.press('+');
    assertEquals("true", browser.evaluate(zoomed));
    browser.press(HOME);
    assertEquals("false", browser.evaluate(zoomed));
  }
}
