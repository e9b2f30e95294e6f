package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.process.JavaProcess.Setting;

/** The studio as its user meets it: a real server, in a real browser. */
class StudioTest {
  private static final String URBI = "org.urbi.server.cli.UrbiCommand";
  private static final String PROGRAM =
      """
      var Global.n = 0|;
      counting: every (10ms) { n++ },
      waiting: waituntil (n < 0),
      function Global.rest() { sleep(1h) }|;
      resting: rest(),
      at (n < 0 && n > -1000000 && n != -12345) echo("a reaction that is longer than a telephone is wide");
      many: for& (10000) sleep(1h),
      """;

  private static final String LETTERS =
      "return parseFloat(getComputedStyle(document.body).fontSize)";

  /** JavaScript that finds the row of the job whose code begins like that. */
  private static String row(String code) {
    return "[...document.querySelectorAll('.row:not(.ended)')]"
        + ".find(row => row.querySelector('.code').textContent.startsWith('"
        + code
        + "'))";
  }

  private static String button(String of, String name) {
    return "[..." + of + ".querySelectorAll('button')].find(b => b.textContent === '" + name + "')";
  }

  private static String tag(String name) {
    return "document.querySelector('[data-tag=" + name + "]')";
  }

  @Test
  void jobsAreSeenAndSteeredInABrowser(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      JavaProcess urbi = page.urbi();
      seesJobs(browser);
      seesLanes(browser);
      seesCalls(browser);
      stopsMany(browser);
      goesBackInTime(browser);
      Accessibility.check(browser);
      fitsAnyScreen(browser);
      steersJobs(browser, urbi);
      usesKeysAlone(browser);
      ForeignPage.attack(browser, urbi, page.address());
      urbi.send("System.studio;\n");
      urbi.awaitText("\"" + page.address() + "\"");
      String state = "return document.querySelector('#connection').dataset.state";
      browser.open(page.address());
      browser.await("the stream", state, "live"::equals);
      urbi.send("shutdown;\n");
      browser.await("the loss of the connection", state, "lost"::equals);
      assertEquals(0, urbi.awaitEnd(), urbi::text);
      assertTrue(!urbi.text().contains("internal error"), urbi::text);
      comesBackAndObserves(browser, page.address(), folder);
    }
  }

  /** The server is started again, and asks for tokens now. */
  private static void comesBackAndObserves(Browser browser, String address, Path folder)
      throws Exception {
    String tokens = StudioPage.tokens(folder, "observer 0123456789abcdef visitor\n");
    String port = address.replaceAll("\\D", "");
    List<String> words =
        List.of(
            "--studio=" + port,
            "--tokens",
            tokens,
            "--default-role",
            "owner",
            "-i",
            "-e",
            "patient: sleep(1h),");
    String connection = StudioPage.text("#connection");
    String role = StudioPage.text("#role");
    try (JavaProcess urbi = JavaProcess.start(Setting.in(folder), URBI, words)) {
      browser.await("the server again", "return !!" + row("sleep"), "true"::equals);
      assertEquals("live", browser.evaluate(connection));
      assertEquals("owner", browser.evaluate(role));
      String button = button(tag("patient"), "Stop");
      String stop = "return " + tag("patient") + " && " + button + ".disabled";
      browser.await("what may be stopped", stop, "false"::equals);
      browser.open(address + "?token=0123456789abcdef");
      browser.await("the role", role, "observer"::equals);
      assertEquals(address, browser.evaluate("return location.href"));
      browser.await("what may not be stopped", stop, "true"::equals);
      browser.evaluate("location.hash = 'variables'");
      String record = "return document.querySelector('#record')?.disabled";
      browser.await("what may not be recorded", record, "true"::equals);
      browser.open(address + "?token=fedcba9876543210");
      browser.await("why not", connection, text -> text.contains("wrong token"));
      urbi.send("shutdown;\n");
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
  }

  /** Two fingers show less of the time, one goes back; a touch tells what happened there. */
  private static void goesBackInTime(Browser browser) throws Exception {
    String place =
        """
        const {left, top, width, height} = document.querySelector('#lanes').getBoundingClientRect();
        const {top: above, height: high} = %s.getBoundingClientRect();
        return Math.round(%%s);
        """
            .formatted(row("every"));
    int right = Integer.parseInt(browser.evaluate(place.formatted("left + width - 8")));
    int counting = Integer.parseInt(browser.evaluate(place.formatted("above + high / 2")));
    String told =
        "document.querySelector('#list').dispatchEvent(new PointerEvent('pointermove', {clientX: %d, clientY: %d}));"
                .formatted(right, counting)
            + StudioPage.text("#turn");
    browser.await("what it did", told, text -> text.matches(".* ran for .* waited for time"));
    int x = Integer.parseInt(browser.evaluate(place.formatted("left + width / 2")));
    int y = Integer.parseInt(browser.evaluate(place.formatted("top + height / 2")));
    browser.spread(x, y);
    String span = "return Number(document.querySelector('#lanes').dataset.span)";
    browser.await("less of the time", span, now -> Double.parseDouble(now) < 30_000);
    browser.swipe(x, y, x + 50);
    String end = StudioPage.text("#to");
    browser.await("earlier times", end, text -> text.endsWith(" s ago"));
    String paused = "return document.querySelector('#pause').getAttribute('aria-pressed')";
    assertEquals("true", browser.evaluate(paused));
    browser.evaluate("document.querySelector('#pause').click()");
    browser.await("the present", end, "now"::equals);
    String press =
        "document.querySelector('#list').dispatchEvent(new KeyboardEvent('keydown', {key: '-'}));";
    browser.evaluate(press.repeat(9));
    browser.await("all of it", span, "60000"::equals);
  }

  private static void seesJobs(Browser browser) throws Exception {
    String state = ".querySelector('.state').textContent";
    String event = "return " + row("waituntil") + "?" + state;
    browser.await("the job that waits", event, "condition"::equals);
    browser.await("the one that counts", "return " + row("every") + "?" + state, "time"::equals);
    String count =
        "return Number(document.querySelector('#count').textContent.replace(/\\D/g, ''))";
    browser.await("all jobs", count, text -> Integer.parseInt(text) > 10000);
    String rows = browser.evaluate("return document.querySelectorAll('.row').length");
    assertTrue(Integer.parseInt(rows) < 100, rows + " rows of 10000 jobs are in the document");
    assertEquals("true", browser.evaluate("return document.body.scrollWidth <= innerWidth"));
  }

  private static void seesLanes(Browser browser) throws Exception {
    browser.await(
        "the turns of the job that counts",
        """
        const canvas = document.querySelector('#lanes');
        const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
        return new Set(new Uint32Array(pixels.buffer)).size;
        """,
        colours -> Integer.parseInt(colours) > 3);
  }

  private static void seesCalls(Browser browser) throws Exception {
    browser.evaluate(row("sleep(1h)") + ".click()");
    browser.await(
        "where it is",
        "return document.querySelector('#job').textContent",
        text ->
            text.contains("function Global.rest() { sleep(1h) }")
                && text.contains("resting: rest(),")
                && text.contains("program.u:4."));
  }

  /** What of a page is cut or too small for a finger; and every room is there. */
  private static void fitsAnyScreen(Browser browser) throws Exception {
    browser.becomeTelephone();
    for (String room : new String[] {"reactions", "variables", "code", "robot", "jobs"}) {
      browser.evaluate("document.querySelector('nav a[href=\"#" + room + "\"]').click()");
      String open = "return !!document.querySelector('[data-room=" + room + "]:not([hidden])')";
      browser.await("the room " + room, open, "true"::equals);
      Fit.checkForFingers(browser, room);
    }
    browser.becomeScreen(1000, 800);
    String lines =
        "return new Set([...document.querySelectorAll('header *')].map(each => "
            + "Math.round(each.getBoundingClientRect().top / 60))).size";
    browser.await("the whole header in one line", lines, "1"::equals);
    String code =
        "return document.querySelector('[data-room=jobs] .columns span').offsetWidth > 240";
    browser.await("room for what jobs do", code, "true"::equals);
    browser.becomeWall();
    browser.await("large letters", LETTERS, size -> Double.parseDouble(size) > 24);
    Fit.check(browser, "on a wall");
    browser.becomeUsual();
    browser.await("usual letters", LETTERS, "15"::equals);
  }

  private static void stopsMany(Browser browser) throws Exception {
    browser.evaluate(button(tag("many"), "Stop") + ".click()");
    String count =
        "return Number(document.querySelector('#count').textContent.replace(/\\D/g, ''))";
    browser.await("the end of many jobs", count, text -> Integer.parseInt(text) < 20);
  }

  private static void steersJobs(Browser browser, JavaProcess urbi) throws Exception {
    browser.evaluate(button("document.querySelector('#job')", "Stop") + ".click()");
    String detail = "return document.querySelector('#job').textContent";
    browser.await("the end of the job", detail, text -> text.contains("has ended"));
    browser.evaluate(button(tag("counting"), "Freeze") + ".click()");
    browser.await(
        "the tag", "return " + tag("counting") + ".textContent", t -> t.contains("frozen"));
    String state = "return " + row("every") + "?.querySelector('.state').textContent";
    browser.await("its job", state, "frozen"::equals);
    urbi.send("var a = n| sleep(50ms)| [a == n];\n");
    urbi.awaitText("[true]");
    browser.evaluate(button(tag("counting"), "Unfreeze") + ".click()");
    urbi.send("waituntil (n > a) | [a < n, 1];\n");
    urbi.awaitText("[true, 1]");
    browser.evaluate(button(tag("counting"), "Block") + ".click()");
    browser.await(
        "the tag", "return " + tag("counting") + ".textContent", t -> t.contains("blocked"));
  }

  private static void usesKeysAlone(Browser browser) throws Exception {
    String press =
        "document.querySelector('#list').dispatchEvent(new KeyboardEvent('keydown', {key: '%s'}));";
    browser.evaluate(press.formatted("Home") + press.formatted("ArrowDown"));
    String selected =
        "return document.querySelector('[aria-selected=true]')?.getAttribute('aria-level')";
    assertEquals("2", browser.evaluate(selected));
    browser.evaluate(
        "document.querySelector('#filter').value = 'waituntil';"
            + "document.querySelector('#filter').dispatchEvent(new Event('input'))");
    browser.await("the filter", "return !!" + row("waituntil"), "true"::equals);
    browser.evaluate(row("waituntil") + ".click();" + press.formatted("s"));
    browser.await("the end of the job", "return !!" + row("waituntil"), "false"::equals);
  }
}
