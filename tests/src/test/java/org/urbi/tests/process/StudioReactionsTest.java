package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The studio's room of reactions and events, in a real browser. */
class StudioReactionsTest {
  private static final String PROGRAM =
      """
      var Global.x = 0|;
      var Global.ball = Event.new|;
      var Global.held = []|;
      at (ball?(var n, var name)) held << [n, name];
      at (x > 5) echo("far");
      whenever (x > 50) echo("gone"),
      counting: every (50ms) 1,
      """;

  private static String row(String code) {
    return "[...document.querySelectorAll('#reaction-table tbody tr')]"
        + ".find(row => row.querySelector('.code').textContent.startsWith('"
        + code
        + "'))";
  }

  private static String cell(String code, int index) {
    return "return " + row(code) + "?.children[" + index + "].textContent";
  }

  @Test
  void reactionsAreSeenAndEventsEmittedInABrowser(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "#reactions")) {
      Browser browser = page.browser();
      browser.await("what it has read", cell("at (x > 5)", 1), "x"::equals);
      assertEquals("0", browser.evaluate(cell("at (x > 5)", 2)));
      page.urbi().send("x = 6;\n");
      browser.await("how often it was", cell("at (x > 5)", 2), "1"::equals);
      browser.await("that it goes on", cell("every (50ms)", 2), t -> Integer.parseInt(t) > 20);
      assertEquals("x", browser.evaluate(cell("whenever (x > 50)", 1)));
      emits(browser, page.urbi());
      Accessibility.check(browser);
      readsOnATelephone(browser);
      filters(browser);
      goesToAnotherRoom(browser, page.urbi());
      assertTrue(!page.urbi().text().contains("internal error"), page.urbi()::text);
    }
  }

  private static void emits(Browser browser, JavaProcess urbi) throws Exception {
    String event = "document.querySelector('[data-event=ball] button')";
    browser.evaluate(event + ".click()");
    String result = StudioPage.text("#emission-result");
    String submit = "; document.querySelector('#emission').requestSubmit()";
    browser.evaluate(StudioPage.type("#payload", "3 + 4, \"red\"") + submit);
    browser.await("that it was emitted", result, "ball was emitted."::equals);
    urbi.send("held;\n");
    urbi.awaitText("[[7, \"red\"]]");
    browser.evaluate(StudioPage.type("#payload", "3 +") + submit);
    browser.await("what is wrong", result, text -> text.contains("syntax error"));
    String alerted = "return !document.querySelector('#alert').hidden";
    assertEquals("false", browser.evaluate(alerted), "what is told beside the button is told once");
    browser.evaluate(StudioPage.type("#payload", "nobody") + submit);
    browser.await("what is wrong", result, text -> text.contains("lookup failed: nobody"));
    browser.evaluate(StudioPage.type("#payload", "' + '1'.repeat(9000) + '") + submit);
    browser.await(
        "that it is too long", result, "payload: at most 8192 characters, not 9000"::equals);
    urbi.send("held.size + 100;\n");
    urbi.awaitText("101");
    isToldWhatIsTooLongToBeSent(browser, urbi);
  }

  /** The server would end the connection, and with it all that runs for this page. */
  private static void isToldWhatIsTooLongToBeSent(Browser browser, JavaProcess urbi)
      throws Exception {
    String result = StudioPage.text("#emission-result");
    String submit = "; document.querySelector('#emission').requestSubmit()";
    browser.evaluate(StudioPage.type("#payload", "' + 'é'.repeat(600000) + '") + submit);
    browser.await(
        "that it is not sent",
        result,
        text ->
            text.matches(
                "This is too long: 1,200,\\d+ bytes, at most 1,048,576 can be sent at once."));
    String kept = "return document.querySelector('#payload').value.length";
    assertEquals("600000", browser.evaluate(kept));
    browser.evaluate(StudioPage.type("#reaction-filter", "' + 'x'.repeat(1100000) + '"));
    browser.await("why", StudioPage.text("#alert"), text -> text.startsWith("This is too long"));
    browser.evaluate(StudioPage.type("#reaction-filter", ""));
    browser.evaluate(StudioPage.type("#payload", "8, \"blue\"") + submit);
    browser.await("that it was emitted", result, "ball was emitted."::equals);
    urbi.send("held.back;\n");
    urbi.awaitText("[8, \"blue\"]");
    String connections = "return document.querySelector('#connection').dataset.connections";
    assertEquals("1", browser.evaluate(connections));
    assertEquals("live", browser.evaluate(StudioPage.text("#connection-text")));
  }

  /** What a condition has read has no column there, and is below the code. */
  private static void readsOnATelephone(Browser browser) throws Exception {
    browser.becomeTelephone();
    String read = row("at (x > 5)") + ".querySelector('.reads')";
    String seen = "return %s.checkVisibility() && %s.textContent".formatted(read, read);
    browser.await("what it has read", seen, "has read x"::equals);
    Fit.checkForFingers(browser, "on a telephone");
    Accessibility.check(browser);
    browser.becomeUsual();
    browser.await("the column", seen, "false"::equals);
  }

  private static void filters(Browser browser) throws Exception {
    String count = "return document.querySelectorAll('#reaction-table tbody tr').length";
    browser.evaluate(StudioPage.type("#reaction-filter", "BALL"));
    browser.await("only one reaction", count, "1"::equals);
    browser.evaluate(StudioPage.type("#reaction-filter", ""));
    browser.await("all reactions", count, "4"::equals);
  }

  private static void goesToAnotherRoom(Browser browser, JavaProcess urbi) throws Exception {
    browser.evaluate("document.querySelector('nav a[href=\"#jobs\"]').click()");
    String shown = "return document.querySelector('[data-room]:not([hidden])').dataset.room";
    browser.await("the room of the jobs", shown, "jobs"::equals);
    assertEquals("Jobs", browser.evaluate(StudioPage.text("nav a[aria-current=page]")).toString());
    browser.evaluate("location.hash = '#nonsense/%'");
    browser.await("the first room", shown, "jobs"::equals);
    browser.evaluate("history.go(-2)");
    browser.await("the room of the reactions", shown, "reactions"::equals);
    String rows = "return document.querySelectorAll('#reaction-table tbody tr').length";
    browser.await("its reactions again", rows, "4"::equals);
    // Who is back before the server has noticed that he was away is not told again what he knows.
    browser.evaluate(
        "document.querySelector('nav a[href=\"#jobs\"]').click();"
            + "setTimeout(() => document.querySelector('nav a[href=\"#reactions\"]').click())");
    browser.await("the room of the reactions", shown, "reactions"::equals);
    urbi.send("x = 0; x = 7;\n");
    browser.await("what goes on", cell("at (x > 5)", 2), "2"::equals);
    assertEquals("4", browser.evaluate(rows));
  }
}
