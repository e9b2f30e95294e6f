package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.StudioEditor.EDITOR;
import static org.urbi.tests.process.StudioEditor.press;
import static org.urbi.tests.process.StudioEditor.text;
import static org.urbi.tests.process.StudioEditor.write;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files of the server in the studio's room of code, in a real browser. */
class StudioFilesTest {
  private static final char TAB = '\ue004';
  private static final char ENTER = '\ue007';
  private static final char DOWN = '\ue015';

  private static final String SAID = StudioPage.text("#file-state");
  private static final String OPEN = "document.querySelector('#open-file').click()";
  private static final String FIRST_LINE = text(EDITOR, ".cm-line");

  private static String choose(String name) {
    return "document.querySelector('#files').value = '" + name + "'; " + OPEN;
  }

  @Test
  void filesAreOpenedAndSavedInABrowser(@TempDir Path folder) throws Exception {
    Files.writeString(folder.resolve("another.u"), "other;");
    try (StudioPage page = StudioPage.start(folder, "var Global.x = 0|;\n", "#code")) {
      Browser browser = page.browser();
      browser.await("the files", StudioPage.text("#files"), text -> text.contains("program.u"));
      browser.await("the editor", FIRST_LINE, text -> text.contains("Ctrl-Enter"));
      opensByKeys(browser);
      editsFiles(browser, folder.resolve("program.u"));
      refusesWhatIsTooLong(browser, folder.resolve("another.u"));
      wantsAName(browser);
      assertTrue(!page.urbi().text().contains("internal error"), page.urbi()::text);
    }
  }

  @Test
  void whatWasTypedIsNotLostUnasked(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, "var Global.x = 0|;\n", "#code")) {
      Browser browser = page.browser();
      browser.await("the files", StudioPage.text("#files"), text -> text.contains("program.u"));
      browser.await("the editor", FIRST_LINE, text -> text.contains("Ctrl-Enter"));
      write(browser, EDITOR, "never saved;");
      browser.evaluate(choose("program.u"));
      String asked = "what was typed is not saved: save it, or open program.u again to lose it";
      browser.await("the question", SAID, asked::equals);
      assertEquals("never saved;", browser.evaluate(FIRST_LINE));
      // Who goes on to type has something else to lose.
      write(browser, EDITOR, "typed since;");
      browser.evaluate("document.querySelector('#file-state').textContent = ''; " + OPEN);
      browser.await("the question again", SAID, asked::equals);
      browser.evaluate(OPEN);
      browser.await("that it is opened", SAID, "program.u is opened"::equals);
      assertEquals("var Global.x = 0|;", browser.evaluate(FIRST_LINE));
      write(browser, EDITOR, "changed;");
      browser.evaluate(OPEN);
      browser.await("the question", SAID, said -> said.startsWith("program.u is not saved: "));
      assertEquals("changed;", browser.evaluate(FIRST_LINE));
    }
  }

  /** An arrow key goes through the list, as far as one likes. */
  private static void opensByKeys(Browser browser) throws Exception {
    String first = browser.evaluate(FIRST_LINE);
    browser.evaluate("document.querySelector('#files').focus()");
    browser.press(DOWN);
    browser.press(DOWN);
    assertEquals("program.u", browser.evaluate("return document.querySelector('#files').value"));
    assertEquals(first, browser.evaluate(FIRST_LINE));
    browser.press(TAB);
    browser.press(ENTER);
    browser.await("that it is opened", SAID, "program.u is opened"::equals);
    assertEquals("var Global.x = 0|;", browser.evaluate(FIRST_LINE));
  }

  private static void editsFiles(Browser browser, Path file) throws Exception {
    write(browser, EDITOR, "mine;");
    browser.evaluate(press(EDITOR, "s", true));
    browser.await("that it is saved", SAID, "program.u is saved"::equals);
    assertEquals("mine;", Files.readString(file));
    Files.writeString(file, "theirs;");
    browser.evaluate("document.querySelector('#save-file').click()");
    browser.await("that it is not", SAID, text -> text.contains("has been changed meanwhile"));
    assertEquals("theirs;", Files.readString(file));
  }

  /** That a text is too long is told, and all else goes on. */
  private static void refusesWhatIsTooLong(Browser browser, Path file) throws Exception {
    browser.evaluate(choose("another.u"));
    browser.await("that it is opened", SAID, "another.u is opened"::equals);
    write(browser, EDITOR, "${'x;'.repeat(70000)}");
    browser.evaluate(press(EDITOR, "s", true));
    browser.await("why not", SAID, "at most 131,072 characters can be saved, not 140,000"::equals);
    assertEquals("other;", Files.readString(file));
    write(browser, EDITOR, "short;");
    browser.evaluate(press(EDITOR, "s", true));
    browser.await("that it is saved", SAID, "another.u is saved"::equals);
    assertEquals("short;", Files.readString(file));
  }

  private static void wantsAName(Browser browser) throws Exception {
    browser.evaluate(StudioPage.type("#file-name", " "));
    browser.evaluate(press(EDITOR, "s", true));
    browser.await("what is missing", SAID, "give the file a name that ends in .u"::equals);
    assertEquals("file-name", browser.evaluate("return document.activeElement.id"));
  }
}
