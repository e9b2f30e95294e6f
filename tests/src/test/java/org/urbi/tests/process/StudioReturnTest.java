package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.process.JavaProcess.Setting;

/**
 * The connection of the studio, in a real browser: who looks away and comes back, servers that are
 * started again, tokens that are wrong.
 */
class StudioReturnTest {
  private static final String PROGRAM =
      """
      var Global.ball = Event.new|;
      first: sleep(1h),
      second: sleep(1h),
      """;

  private static final String CONNECTION = StudioPage.text("#connection");
  private static final String STATE = "return document.querySelector('#connection').dataset.state";
  private static final String CONNECTIONS =
      "return document.querySelector('#connection').dataset.connections";

  private static final String PAUSED =
      "return document.querySelector('#pause').getAttribute('aria-pressed')";

  private static final String SELECTED = "return !!document.querySelector('[aria-selected=true]')";

  /** JavaScript: whether somebody can see the page. */
  private static String hidden(boolean is) {
    return "Object.defineProperty(document, 'hidden', {value: "
        + is
        + ", configurable: true}); document.dispatchEvent(new Event('visibilitychange'))";
  }

  private static void chooses(Browser browser) throws Exception {
    String event = "document.querySelector('[data-event=ball] button')";
    browser.await("the event", "return !!" + event, "true"::equals);
    browser.evaluate(event + ".click()");
    browser.await("the choice", StudioPage.text("#emission-event"), "ball"::equals);
    browser.evaluate("location.hash = 'jobs'");
    String row = StudioPage.row("first");
    browser.await("the job", "return !!" + row, "true"::equals);
    browser.evaluate(row + ".click()");
    browser.await("its name", StudioPage.text("#job"), text -> text.contains("Stop"));
    browser.evaluate("document.querySelector('#pause').click()");
    browser.await("the pause", PAUSED, "true"::equals);
  }

  /** The numbers of another server mean other jobs: who presses a key there must not stop one. */
  @Test
  void nothingIsChosenOfAnotherServer(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "#reactions")) {
      Browser browser = page.browser();
      chooses(browser);
      // Who does not look connects again when he does, and not before.
      browser.evaluate(hidden(true));
      page.urbi().send("shutdown;\n");
      assertEquals(0, page.urbi().awaitEnd(), page.urbi()::text);
      browser.await("that it rests", STATE, "waiting"::equals);
      String file = folder.resolve("program.u").toString();
      try (JavaProcess urbi = StudioPage.serve(Setting.in(folder), page.port(), "-f", file)) {
        urbi.awaitText("studio: ");
        assertEquals("1", browser.evaluate(CONNECTIONS));
        browser.evaluate(hidden(false));
        browser.await("the other server", CONNECTIONS, "2"::equals);
        browser.await("its jobs", "return !!" + StudioPage.row("first"), "true"::equals);
        String detail = StudioPage.text("#job");
        browser.await("no job", detail, text -> text.contains("Choose a job"));
        assertEquals("false", browser.evaluate(SELECTED));
        assertEquals("false", browser.evaluate(PAUSED));
        browser.evaluate("location.hash = 'reactions'");
        String event = "return !!document.querySelector('[data-event=ball]')";
        browser.await("its event", event, "true"::equals);
        assertEquals("Choose an event.", browser.evaluate(StudioPage.text("#emission-event")));
        assertEquals("true", browser.evaluate("return document.querySelector('#emit').disabled"));
        urbi.send("shutdown;\n");
        assertEquals(0, urbi.awaitEnd(), urbi::text);
      }
    }
  }

  /** Browsers keep pages, and show them again before they have told of the end of a connection. */
  @Test
  void whoComesBackHasOneConnectionAndWhatWasChosen(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "#reactions")) {
      Browser browser = page.browser();
      chooses(browser);
      String comesBack =
          "window.dispatchEvent(new Event('pagehide')); window.dispatchEvent(new Event('pageshow'));";
      browser.evaluate(
          """
          window.sockets = [];
          window.waits = [];
          const Socket = WebSocket;
          window.WebSocket = class extends Socket {
            constructor(...all) {
              super(...all);
              window.sockets.push(this);
            }
          };
          const later = setTimeout;
          window.setTimeout = (what, wait, ...more) => {
            window.waits.push(wait);
            return later(what, wait, ...more);
          };
          """
              + comesBack.repeat(2));
      browser.await("the server again", CONNECTIONS, "2"::equals);
      String states = "return window.sockets.map((each) => each.readyState).join(' ')";
      browser.await("the end of one, and the other one", states, "3 1"::equals);
      assertEquals("false", browser.evaluate("return window.waits.includes(300)"));
      browser.await("its jobs", "return !!" + StudioPage.row("second"), "true"::equals);
      assertEquals("true", browser.evaluate(SELECTED));
      assertEquals("true", browser.evaluate(PAUSED));
      page.urbi().send("first.stop;\n");
      String detail = StudioPage.text("#job");
      browser.await("the end of the job", detail, text -> text.contains("has ended"));
      endsWhileNobodyLooks(browser, page.urbi(), comesBack);
    }
  }

  private static void endsWhileNobodyLooks(Browser browser, JavaProcess urbi, String comesBack)
      throws Exception {
    browser.evaluate("window.dispatchEvent(new Event('pagehide'))");
    browser.await("that it rests", STATE, "waiting"::equals);
    urbi.send("second.stop; [8];\n");
    urbi.awaitText("[8]");
    browser.evaluate(comesBack);
    browser.await("its end", "return !!" + StudioPage.row("second"), "false"::equals);
    String ended = "return " + StudioPage.rows("second", ".ended") + ".length";
    assertEquals("1", browser.evaluate(ended));
  }

  /** The address without a token lets in whom a wrong one does not. */
  @Test
  void wrongTokenIsForgottenAndAnotherOneIsAskedFor(@TempDir Path folder) throws Exception {
    String tokens = StudioPage.tokens(folder, "owner 0123456789abcdef boss\n");
    Browser browser = Browser.flat();
    try (JavaProcess urbi =
        StudioPage.serve(
            Setting.in(folder), "0", "--tokens", tokens, "--default-role", "observer")) {
      String line = urbi.awaitText("studio: ");
      String address = line.replaceFirst(".*studio: ", "");
      String role = StudioPage.text("#role");
      String asks = "return !document.querySelector('#entry').hidden";
      String stored = "return sessionStorage.getItem('token')";
      browser.open(address + "?token=fedcba9876543210");
      browser.await("why not", CONNECTION, text -> text.contains("wrong token"));
      assertEquals("true", browser.evaluate(asks));
      assertEquals("null", browser.evaluate(stored));
      Accessibility.check(browser);
      browser.open(address);
      browser.await("the role of all", role, "observer"::equals);
      assertEquals("false", browser.evaluate(asks));
      browser.open(address + "?token=fedcba9876543210");
      browser.await("why not", STATE, "lost"::equals);
      // The right one may have to wait as well, and is tried again then.
      String enter = "; document.querySelector('#entry').requestSubmit()";
      browser.evaluate(StudioPage.type("#token", "0123456789abcdef") + enter);
      browser.await("the role of that token", role, "owner"::equals);
      assertEquals("false", browser.evaluate(asks));
      assertEquals("0123456789abcdef", browser.evaluate(stored));
      browser.open(address);
      browser.await("the role again", role, "owner"::equals);
      browser.leave();
      urbi.send("shutdown;\n");
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
  }

  @Test
  void pageNeedsNoStorage(@TempDir Path folder) throws Exception {
    String denied = "Object.defineProperty(window, '%s', {get() { throw new Error('denied'); }});";
    Browser browser = Browser.flat();
    Browser.Closing blocked =
        browser.beforeAll(denied.formatted("localStorage") + denied.formatted("sessionStorage"));
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "?token=unasked")) {
      assertEquals(browser, page.browser());
      browser.await("jobs", "return !!" + StudioPage.row("first"), "true"::equals);
      browser.evaluate("document.querySelector('#theme').click()");
      String theme = browser.evaluate("return document.documentElement.dataset.theme");
      assertTrue(theme.matches("light|dark"), theme);
      browser.evaluate("location.hash = 'code'");
      browser.await("the editor", StudioPage.text("#code-state"), "no syntax error"::equals);
    } finally {
      blocked.close();
    }
  }

  /** A kernel that does not answer is told of once, and for how long to those who see. */
  @Test
  void busyKernelIsReadAloudOnce(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      browser.await("jobs", "return !!" + StudioPage.row("first"), "true"::equals);
      String status = "document.querySelector('#connection-text')";
      browser.evaluate(
          "window.told = []; new MutationObserver(() => window.told.push("
              + status
              + ".textContent)).observe("
              + status
              + ", {childList: true})");
      signal(page.urbi(), "STOP");
      try {
        String busy = StudioPage.text("#busy");
        browser.await("for how long", busy, text -> text.matches(" for \\d+ s"));
        String first = browser.evaluate(busy);
        browser.await("that it goes on", busy, text -> !text.equals(first));
        assertEquals("the kernel is busy", browser.evaluate("return window.told.join()"));
        String aloud = "return !document.querySelector('#busy').closest('[aria-hidden=true]')";
        assertEquals("false", browser.evaluate(aloud));
      } finally {
        signal(page.urbi(), "CONT");
      }
      browser.await("that it lives", CONNECTION, "live"::equals);
    }
  }

  private static void signal(JavaProcess process, String name) throws Exception {
    String[] words = {"kill", "-" + name, String.valueOf(process.pid())};
    assertEquals(0, new ProcessBuilder(words).inheritIO().start().waitFor());
  }
}
