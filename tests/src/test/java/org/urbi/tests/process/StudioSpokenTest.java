package org.urbi.tests.process;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** All rooms of the studio, in a real browser, by somebody who has the page read aloud. */
class StudioSpokenTest {
  private static final char ENTER = '\ue007';

  private static final String PROGRAM =
      """
      var Global.e = Event.new|;
      var Global.lost = Event.new|;
      var Global.n = 5|; Global.n->rangemin = 0|; Global.n->rangemax = 10|;
      var Global.brief = 1|;
      reacting: at (e?) n++;
      beating: every (1h) e!,
      patient: sleep(1h),
      other: sleep(1h),
      """;

  /** By what the part of the page is known that has the keys. */
  private static final String PART =
      "const at = document.activeElement; return at.id || at.getAttribute('aria-labelledby')";

  private static void goTo(Browser browser, String room) throws Exception {
    browser.evaluate("location.hash = '" + room + "'");
    String open = "return !!document.querySelector('[data-room=" + room + "]:not([hidden])')";
    browser.await("the room " + room, open, "true"::equals);
  }

  /** Does something with an element as soon as it is there. */
  private static void use(Browser browser, String element, String what) throws Exception {
    String use = "const found = " + element + "; found?." + what + "; return !!found";
    browser.await(element, use, "true"::equals);
  }

  private static String button(String within, String text) {
    return "[...document.querySelectorAll('"
        + within
        + " button')].find(each => each.textContent === '"
        + text
        + "' && !each.disabled)";
  }

  private static void isTold(Browser browser, String id, String text) throws Exception {
    browser.await(id, StudioPage.text("#" + id + "[role=status]"), text::equals);
  }

  @Test
  void eachControlTellsWhatItIs(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      use(browser, StudioPage.row("patient"), "click()");
      use(browser, button("#job", "Stop"), "focus()");
      SpokenPage.check(browser, "jobs");
      goTo(browser, "reactions");
      use(browser, button("#event-list", "e"), "click()");
      use(browser, "document.querySelector('#reaction-table tbody tr')", "isConnected");
      SpokenPage.check(browser, "reactions");
      goTo(browser, "variables");
      use(browser, StudioPage.line("Global .n"), "click()");
      use(browser, button("#slot", "Plot"), "click()");
      use(browser, "document.querySelector('#slot-range:not([hidden])')", "isConnected");
      use(browser, "document.querySelector('#plotted button')", "isConnected");
      SpokenPage.check(browser, "variables");
      goTo(browser, "code");
      StudioEditor.write(browser, StudioEditor.EDITOR, "sleep(1h);");
      use(browser, button("[data-room=code]", "Run"), "click()");
      use(browser, button("#runs", "Stop"), "isConnected");
      SpokenPage.check(browser, "code");
      goTo(browser, "robot");
      SpokenPage.check(browser, "robot");
    }
  }

  @Test
  void whatChangesIsTold(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      use(browser, StudioPage.row("patient"), "click()");
      browser.evaluate(StudioPage.type("#filter", "sleep(1h)"));
      // And the one that has started them.
      isTold(browser, "jobs-found", "3 jobs shown");
      browser.evaluate(StudioPage.type("#filter", "nobody has this"));
      isTold(browser, "jobs-found", "0 jobs shown");
      browser.evaluate(StudioPage.type("#filter", ""));
      isTold(browser, "jobs-found", "");
      page.urbi().send("patient.stop;\n");
      isTold(browser, "job-state", "The selected job has ended.");
      goTo(browser, "reactions");
      browser.evaluate(StudioPage.type("#reaction-filter", "lost"));
      isTold(browser, "reactions-found", "0 reactions, 1 event found");
      goTo(browser, "variables");
      browser.await("n", StudioPage.value("Global .n"), "5"::equals);
      browser.evaluate(StudioPage.type("#variable-filter", "brief"));
      isTold(browser, "variables-found", "1 slot shown");
    }
  }

  /** Who has nothing but keys would begin at the top of the page again. */
  @Test
  void keysStayWhereSomethingHasGone(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      JavaProcess urbi = page.urbi();
      use(browser, StudioPage.row("patient"), "click()");
      use(browser, button("#job", "Stop"), "focus()");
      browser.press(ENTER);
      browser.await("where it was told of", PART, "detail"::equals);
      use(browser, button("[data-tag=other]", "Stop"), "focus()");
      browser.press(ENTER);
      browser.await("where its tag was", PART, "tags"::equals);
      goTo(browser, "reactions");
      use(browser, button("#event-list", "lost"), "click()");
      browser.await("its payload", PART, "payload"::equals);
      urbi.send("Global.removeLocalSlot(\"lost\");\n");
      browser.await("where it was emitted", PART, "emission"::equals);
      use(browser, button("#event-list", "e"), "focus()");
      urbi.send("reacting.stop| beating.stop| Global.removeLocalSlot(\"e\");\n");
      browser.await("where the events are", PART, "events-title"::equals);
      goTo(browser, "variables");
      use(browser, StudioPage.line("Global .n"), "click()");
      use(browser, button("#slot", "Plot"), "click()");
      use(browser, "document.querySelector('#plotted button')", "focus()");
      browser.press(ENTER);
      browser.await("where it was plotted", PART, "plot"::equals);
      use(browser, "document.querySelector('#slot-slider')", "focus()");
      urbi.send("Global.n->rangemax = nil|;\n");
      browser.await("where its value is", PART, "assign"::equals);
      use(browser, StudioPage.line("Global .brief"), "click()");
      use(browser, "document.querySelector('#slot-value')", "focus()");
      urbi.send("Global.removeLocalSlot(\"brief\");\n");
      browser.await("where the slot was", PART, "slot"::equals);
      goTo(browser, "code");
      StudioEditor.write(browser, StudioEditor.EDITOR, "sleep(1h);");
      use(browser, button("[data-room=code]", "Run"), "click()");
      use(browser, button("#runs", "Stop"), "focus()");
      browser.press(ENTER);
      browser.await("where it ran", PART, "console-title"::equals);
    }
  }
}
