package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Single jobs in the studio, in a real browser: what they cost, who wakes them, and clicks that
 * freeze them.
 */
class StudioSteeringTest {
  private static final String PROGRAM =
      """
      var Global.n = 0|;
      var Global.heard = 0|;
      var Global.tick = Event.new|;
      busy: loop { n++ },
      beating: loop { sleep(300ms); tick! },
      listening: loop { waituntil (tick?); heard++ },
      """;

  private static String cell(String tag, String selector) {
    return "return " + StudioPage.row(tag) + "?.querySelector('" + selector + "').textContent";
  }

  /** JavaScript that clicks a button of the selected job, once it is there. */
  private static String click(String button) {
    return """
    const button = [...document.querySelectorAll('#job button')].find(each => each.textContent === '%s');
    button?.click();
    return Boolean(button);
    """
        .formatted(button);
  }

  @Test
  void jobIsSeenToCostAndFrozenByAClick(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      seesWhatJobsCost(browser);
      seesWhoWakes(browser);
      freezes(browser, page.urbi());
      buttonsStayWhileFactsChange(browser, page.urbi());
      assertTrue(!page.urbi().text().contains("internal error"), page.urbi()::text);
    }
  }

  private static double percent(String text) {
    return text.matches("[0-9.]+ %") ? Double.parseDouble(text.replace(" %", "")) : 0;
  }

  /**
   * The one that never waits has nearly all of the kernel's time; it is the first of the busiest.
   */
  private static void seesWhatJobsCost(Browser browser) throws Exception {
    browser.await("its share", cell("busy", ".share span"), text -> percent(text) > 50);
    browser.await("that of another", cell("listening", ".share span"), text -> percent(text) < 20);
    String meter = "return " + StudioPage.row("busy") + ".querySelector('meter').value > 50";
    assertEquals("true", browser.evaluate(meter));
    String load =
        "return [...document.querySelectorAll('header dd')].map(each => each.textContent).join(' ')";
    assertTrue(browser.evaluate(load).matches(".*\\d %.*"), () -> "no load in the header");
    String order =
        "const order = document.querySelector('#order'); order.value = '%s';"
            + "order.dispatchEvent(new Event('change'));";
    browser.evaluate(order.formatted("share"));
    String place = "const row = %s; return row?.ariaLevel + ' ' + row?.ariaPosInSet";
    String busy = place.formatted(StudioPage.row("busy"));
    browser.await("the busiest first, below nothing", busy, "1 1"::equals);
    browser.evaluate(order.formatted("tree"));
    browser.await("who has started it above", busy, now -> !now.startsWith("1 "));
  }

  /** Some turn in the lane of the job that waits for the event tells which job has emitted it. */
  private static void seesWhoWakes(Browser browser) throws Exception {
    String waker = browser.evaluate(cell("beating", ".name"));
    String sleeper = browser.evaluate(cell("listening", ".name"));
    browser.await(
        "who has woken it",
        StudioPage.told("listening", "woken by"),
        text ->
            text.matches(
                sleeper
                    + ": ran for [0-9.]+ ms, [0-9.]+ s ago, after it had waited for event, woken by "
                    + waker
                    + ": .+"));
    String kind =
        "document.querySelector('#list').dispatchEvent(new PointerEvent('pointerleave'));";
    String hint = browser.evaluate(kind + StudioPage.text("#turn"));
    assertTrue(hint.startsWith("Draw across the lanes"), hint);
  }

  private static void freezes(Browser browser, JavaProcess urbi) throws Exception {
    String state = cell("busy", ".state");
    assertEquals("running", browser.evaluate(state));
    browser.evaluate(StudioPage.row("busy") + ".click()");
    browser.await("the button", click("Freeze"), "true"::equals);
    browser.await("the frozen job", state, "frozen"::equals);
    browser.await("what it costs then", cell("busy", ".share span"), ""::equals);
    String facts = StudioPage.text("#job");
    browser.await("what is told of it", facts, text -> text.contains("isfrozen"));
    assertEquals("event", browser.evaluate(cell("listening", ".state")));
    urbi.send("var a = n| var b = heard| waituntil (heard > b)| [a == n];\n");
    urbi.awaitText("[true]");
    browser.await("the other button", click("Unfreeze"), "true"::equals);
    browser.await("that it goes on", state, "running"::equals);
    urbi.send("waituntil (n > a)| [a < n, 1];\n");
    urbi.awaitText("[true, 1]");
    browser.await("what it costs again", cell("busy", ".share span"), text -> percent(text) > 50);
    browser.await("the first button again", facts, text -> text.contains("Freeze"));
  }

  /** A click is a press and a release: what is told meanwhile must not take the button away. */
  private static void buttonsStayWhileFactsChange(Browser browser, JavaProcess urbi)
      throws Exception {
    browser.evaluate(StudioPage.row("beating") + ".click()");
    String facts = "document.querySelector('#job .facts')?.textContent";
    browser.await("how long it waits", "return " + facts, text -> text.contains("s more"));
    Accessibility.check(browser);
    String starter =
        "return [...document.querySelectorAll('#job dt')]"
            + ".find(name => name.textContent === 'started by').nextSibling.textContent";
    String shell = browser.evaluate(starter);
    assertTrue(shell.matches("shell_\\d+"), shell + " has no code that could be told");
    String tag = "document.querySelector('[data-tag=beating]')";
    browser.evaluate(
        """
        window.pressed = [document.querySelector('#job button'), %s.querySelector('.danger')];
        window.told = %s;
        """
            .formatted(tag, facts));
    urbi.send("beating: sleep(1h),\n");
    browser.await("another count", "return " + tag + ".textContent", t -> t.contains("2 jobs"));
    browser.await("other facts", "return " + facts + " !== window.told", "true"::equals);
    String stay = "return window.pressed.every(button => button.isConnected)";
    assertEquals("true", browser.evaluate(stay));
  }
}
