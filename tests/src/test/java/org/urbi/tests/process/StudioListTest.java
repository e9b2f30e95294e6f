package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The list of jobs and that of tags, in a real browser, while what they show changes. */
class StudioListTest {
  private static final char ENTER = '\ue007';
  private static final char LEFT = '\ue012';
  private static final char RIGHT = '\ue014';
  private static final String PROGRAM =
      """
      var Global.n = 0|;
      outer: for& (3) sleep(1h),
      busy: loop { n++ },
      other: sleep(1h),
      """;

  private static final String FOCUS = "const {activeElement: it} = document; return it.";

  private static String button(String tag, String name) {
    return "[...document.querySelectorAll('[data-tag="
        + tag
        + "] button')].find(each => each.textContent === '"
        + name
        + "')";
  }

  /** Whoever has nothing but keys would begin at the top of the page after each of them. */
  @Test
  void keysStayAtWhatTheyHaveChanged(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      presses(browser, "other", "Freeze", "Unfreeze");
      presses(browser, "other", "Unfreeze", "Freeze");
      browser.evaluate(StudioPage.row("other") + ".click()");
      String stop = "document.querySelector('#job button')";
      browser.await("the job", "return !!" + stop, "true"::equals);
      browser.evaluate(stop + ".focus()");
      browser.press(ENTER);
      browser.await("its end", StudioPage.text("#job"), text -> text.contains("has ended"));
      assertEquals("detail", browser.evaluate(FOCUS + "id"));
      browser.evaluate(button("busy", "Stop") + ".focus()");
      page.urbi().send("outer.stop;\n");
      String gone = "return !document.querySelector('[data-tag=%s]')";
      browser.await("the end of the tag before", gone.formatted("outer"), "true"::equals);
      assertEquals("Stop", browser.evaluate(FOCUS + "textContent"));
      presses(browser, "busy", "Block", "Unblock");
      browser.press(ENTER);
      browser.await("the end of the tag", gone.formatted("busy"), "true"::equals);
      assertEquals("tags", browser.evaluate(FOCUS + "id"));
    }
  }

  /** Presses a button of a tag, which becomes another one: the keys are there still. */
  private static void presses(Browser browser, String tag, String name, String next)
      throws Exception {
    browser.await("the button", "return !!" + button(tag, name), "true"::equals);
    browser.evaluate(button(tag, name) + ".focus()");
    browser.press(ENTER);
    browser.await("the opposite", "return !!" + button(tag, next), "true"::equals);
    assertEquals(next, browser.evaluate(FOCUS + "textContent"));
  }

  /** The place of a line is told among those of the same starter; the arrows go up and down. */
  @Test
  void treeIsOneForThoseWhoDoNotSeeIt(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      String rows = StudioPage.rows("outer", "");
      browser.await("all jobs", "return " + rows + ".length", "4"::equals);
      String places =
          "return "
              + rows
              + ".map(row => ['level', 'posinset', 'setsize'].map(each => row.getAttribute('aria-' + each)))"
              + ".map(([level, place, of]) => level - %s + ':' + place + '/' + of).slice(1).join(' ')";
      String level = browser.evaluate("return " + rows + "[0].ariaLevel");
      assertEquals("1:1/3 1:2/3 1:3/3", browser.evaluate(places.formatted(level)));
      browser.evaluate("document.querySelector('#list').focus();" + rows + "[2].click()");
      String selected =
          "return %s.findIndex(row => row.ariaSelected === 'true') + ' ' + %s[0].ariaExpanded"
              .formatted(rows, rows);
      assertEquals("2 true", browser.evaluate(selected));
      browser.press(LEFT);
      assertEquals("0 true", browser.evaluate(selected));
      browser.press(RIGHT);
      assertEquals("1 true", browser.evaluate(selected));
      browser.press(LEFT);
      browser.press(LEFT);
      assertEquals("0 false", browser.evaluate(selected));
      browser.press(LEFT);
      String above = "return document.querySelector('[aria-selected=true]').ariaLevel";
      int up = Integer.parseInt(browser.evaluate(above));
      assertEquals(Integer.parseInt(level) - 1, up);
      browser.evaluate(
          "const order = document.querySelector('#order'); order.value = 'share'; order.dispatchEvent(new Event('change'))");
      browser.await("one level", "return " + rows + "[0].ariaLevel", "1"::equals);
    }
  }

  /** Lines are made with each view, not with each picture; none moves away from who presses it. */
  @Test
  void linesStayWhileSomebodyScrollsAndPresses(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      browser.await("jobs", "return !!" + StudioPage.row("outer"), "true"::equals);
      browser.evaluate(
          """
          window.made = 0;
          import('./jobs.js').then(({Jobs}) => {
            for (const lines of ['tree', 'busiest']) {
              const make = Jobs.prototype[lines];
              Jobs.prototype[lines] = function(...all) {
                window.jobs = this;
                window.made++;
                return make.apply(this, all);
              };
            }
          });
          """);
      browser.evaluate(StudioPage.type("#filter", "sleep"));
      browser.await("the filter", "return window.made > 0", "true"::equals);
      browser.evaluate(
          """
          const [made, views] = [window.made, window.jobs.views];
          let pictures = 0;
          const scroll = () => {
            document.querySelector('#list').dispatchEvent(new Event('scroll'));
            if (++pictures < 60) requestAnimationFrame(scroll);
            else window.scrolled = [window.made - made, window.jobs.views - views];
          };
          scroll();
          """);
      browser.await("all pictures", "return !!window.scrolled", "true"::equals);
      String scrolled = browser.evaluate("return window.scrolled.join(' ')");
      String[] counts = scrolled.split(" ");
      assertTrue(
          Integer.parseInt(counts[0]) <= Integer.parseInt(counts[1]) + 1,
          () -> "made, and views: " + scrolled);
      staysWhilePressed(browser);
    }
  }

  private static void staysWhilePressed(Browser browser) throws Exception {
    String press =
        "document.querySelector('#list').dispatchEvent(new PointerEvent('%s', {bubbles: true, button: 0, buttons: %d}));";
    browser.evaluate(
        press.formatted("pointerdown", 1) + "window.pressed = [window.made, window.jobs.views]");
    browser.await(
        "views meanwhile", "return window.jobs.views > window.pressed[1] + 2", "true"::equals);
    String made = "return window.made - window.pressed[0]";
    assertEquals("0", browser.evaluate(made));
    browser.evaluate(press.formatted("pointerup", 0));
    browser.await("that it goes on", made, count -> Integer.parseInt(count) > 0);
  }
}
