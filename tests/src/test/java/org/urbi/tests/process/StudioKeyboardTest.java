package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** All rooms of the studio, in a real browser, by somebody who has nothing but keys. */
class StudioKeyboardTest {
  private static final char TAB = '\ue004';
  private static final char ENTER = '\ue007';
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

  /** From now on it is noted what has been reached. */
  private static final String BEGIN =
      """
      if (!window.walking) document.addEventListener('focusin', ({target}) => target.walked = true);
      window.walking = true;
      for (const element of document.querySelectorAll('*')) element.walked = false;
      """;

  private static final String IS_ROUND = "return document.activeElement === document.body";

  /** What was not reached, and what shows that it can be clicked and is nothing for keys. */
  private static final String MISSED =
      """
      const seen = (element) => element.checkVisibility({visibilityProperty: true});
      const shown = (element) => element.tagName.toLowerCase() + '#' + element.id + '.' + element.className;
      const forKeys = 'button, a[href], select, input, textarea, audio[controls], [tabindex="0"], [contenteditable="true"]';
      const missed = [...document.querySelectorAll(forKeys)]
        .filter((element) => seen(element) && !element.disabled && element.tabIndex >= 0 && !element.walked)
        .map((element) => 'not reached: ' + shown(element));
      for (const element of document.querySelectorAll('body *')) {
        const clicked = seen(element) && getComputedStyle(element).cursor === 'pointer';
        if (clicked && !element.closest(forKeys + ', label')) missed.push('only for a pointer: ' + shown(element));
      }
      return missed.join('\\n');
      """;

  private static final String FOCUS = "return document.activeElement.%s";

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
