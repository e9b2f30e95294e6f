package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.StudioEditor.CONSOLE;
import static org.urbi.tests.process.StudioEditor.EDITOR;
import static org.urbi.tests.process.StudioEditor.in;
import static org.urbi.tests.process.StudioEditor.press;
import static org.urbi.tests.process.StudioEditor.text;
import static org.urbi.tests.process.StudioEditor.write;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The studio's room of code, in a real browser. */
class StudioCodeTest {
  private static final String LOG = StudioPage.text("#log");
  private static final String RUNS = StudioPage.text("#runs");

  private static void run(Browser browser, String text) throws IOException {
    write(browser, EDITOR, text);
    browser.evaluate(press(EDITOR, "Enter", true));
  }

  @Test
  void codeIsWrittenRunAndStoppedInABrowser(@TempDir Path folder) throws Exception {
    String program = "var Global.x = 0|;\n";
    try (StudioPage page = StudioPage.start(folder, program, "#code")) {
      Browser browser = page.browser();
      String state = "return document.querySelector('#connection')?.dataset.state";
      browser.await("the connection", state, "live"::equals);
      browser.await("the editor", text(EDITOR, ".cm-content"), text -> text.contains("echo"));
      runs(browser);
      showsErrors(browser);
      stops(browser, page.urbi());
      hasConsole(browser);
      Accessibility.check(browser);
      completes(browser, CONSOLE);
      completes(browser, EDITOR);
      assertTrue(!page.urbi().text().contains("internal error"), page.urbi()::text);
    }
  }

  private static void runs(Browser browser) throws Exception {
    run(browser, "echo(\"grün\"); x + 41;");
    browser.await("what it says", LOG, text -> text.contains("*** grün"));
    browser.await("its value", LOG, text -> text.contains("] 41"));
    write(browser, EDITOR, "var a = 1000 + 1; a;\n2000 + 2;");
    assertEquals(
        "false",
        browser.evaluate(
            "const [name, ...others] = "
                + in(EDITOR, ".cm-line")
                + ".querySelectorAll('span');"
                + "return getComputedStyle(name).color === getComputedStyle(name.parentNode).color"),
        "the word var has a colour of its own");
    browser.evaluate(press(EDITOR, "Home", "ctrlKey") + press(EDITOR, "End", "shiftKey"));
    browser.evaluate(press(EDITOR, "Enter", true));
    browser.await("the selected line", LOG, text -> text.contains("] 1001"));
    run(browser, "3000 + 3;");
    String log = browser.await("the next text", LOG, text -> text.contains("] 3003"));
    assertTrue(!log.contains("] 2002"), log);
  }

  private static void showsErrors(Browser browser) throws Exception {
    write(browser, EDITOR, "var y = 1;\nif (y == 1) echo(");
    String wrong = StudioPage.text("#code-state");
    browser.await("what is wrong", wrong, text -> text.contains("syntax error"));
    write(browser, EDITOR, "1 + 2;");
    browser.await("that nothing is", wrong, "no syntax error"::equals);
    run(browser, "echo(\"so far\");\n\"grün\"; nobody;\n");
    browser.await("what fails", LOG, text -> text.contains("lookup failed: nobody"));
    String marked = text(EDITOR, ".cm-lintRange-error");
    assertEquals("nobody", browser.await("where it fails", marked, "nobody"::equals));
  }

  private static void stops(Browser browser, JavaProcess urbi) throws Exception {
    String stop = "document.querySelector('#runs button:not([hidden])').click()";
    String stoppable =
        "return document.querySelector('#runs button:enabled:not([hidden])') !== null";
    run(browser, "while| (true) x");
    browser.await("that it runs", RUNS, text -> text.contains("running, under run_"));
    browser.await("that it can be stopped", stoppable, "true"::equals);
    browser.evaluate(stop);
    browser.await("that it was", RUNS, text -> text.contains("it was stopped"));
    run(browser, "every (20ms) x++,");
    browser.await("that it goes on", RUNS, text -> text.contains("goes on, under run_"));
    browser.evaluate(stop);
    browser.await("that it does not", RUNS, text -> !text.contains("goes on"));
    urbi.send("var before = x|; sleep(100ms); x - before + 7000;\n");
    urbi.awaitText("] 7000");
  }

  private static void hasConsole(Browser browser) throws Exception {
    write(browser, CONSOLE, "6 * 700;");
    browser.evaluate(press(CONSOLE, "Enter", false));
    browser.await("the value", LOG, text -> text.contains("> 6 * 700;") && text.contains("4200"));
    browser.evaluate(press(CONSOLE, "ArrowUp", false));
    assertEquals("6 * 700;", browser.evaluate(text(CONSOLE, ".cm-content")));
    endsLines(browser);
  }

  /** What a program has written is seen at once, and apart from what is typed next. */
  private static void endsLines(Browser browser) throws Exception {
    run(browser, "lobby.write(\"half a \");");
    String last = "return document.querySelector('#log').lastChild.textContent";
    browser.await("what is not complete", last, "half a "::equals);
    run(browser, "lobby.write(\"line\");");
    browser.await("the rest of it, behind that", last, "half a line"::equals);
    write(browser, CONSOLE, "8 * 700;");
    browser.evaluate(press(CONSOLE, "Enter", false));
    String lines =
        "return [...document.querySelectorAll('#log div')].slice(-3)"
            + ".map(line => line.textContent.replace(/\\[\\d+\\]/, '[]')).join('|')";
    browser.await("three lines", lines, "half a line|> 8 * 700;|[] 5600"::equals);
  }

  private static void completes(Browser browser, String host) throws Exception {
    write(browser, host, "Mutex.loc");
    browser.evaluate(press(host, " ", true));
    String offered = text(host, ".cm-tooltip-autocomplete");
    browser.await("what may follow", offered, text -> text.contains("lock"));
    browser.await("what it does", text(host, ".cm-completionInfo"), text -> text.length() > 9);
    // The page need not understand what is before the dot.
    offers(browser, host, "[1].siz", "size");
    offers(browser, host, "\"grün\".toUp", "toUpper");
    offers(browser, host, "{ var all = []; all.siz", "size");
    write(browser, host, "[1].siz; \"Mutex.loc");
    browser.evaluate(press(host, " ", true));
    browser.await("that a string is no code", offered, text -> !text.contains("lock"));
  }

  private static void offers(Browser browser, String host, String typed, String name)
      throws Exception {
    String offered = text(host, ".cm-tooltip-autocomplete");
    write(browser, host, "nothing;");
    browser.await("that nothing is offered", offered, text -> !text.contains(name));
    write(browser, host, typed);
    browser.evaluate(press(host, " ", true));
    browser.await("what follows " + typed, offered, text -> text.contains(name));
  }
}
