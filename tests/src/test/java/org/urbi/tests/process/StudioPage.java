package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.urbi.tests.process.JavaProcess.Setting;

/**
 * The studio of a real server, in a real browser.
 *
 * @param address of the page, without a room
 */
record StudioPage(Browser browser, JavaProcess urbi, String address) implements AutoCloseable {
  private static final String URBI = "org.urbi.server.cli.UrbiCommand";
  private static final String ADDRESS = "studio: ";

  /**
   * Starts both in a folder; the test is skipped where there is no browser.
   *
   * @param room to open; empty for the first one
   */
  static StudioPage start(Path folder, String program, String room) throws Exception {
    Path file = Files.writeString(folder.resolve("program.u"), program);
    List<String> words = List.of("--studio=0", "-P", "0", "-i", "-f", file.toString());
    Browser browser = Browser.flat();
    JavaProcess urbi = JavaProcess.start(Setting.in(folder), URBI, words);
    try {
      String line = urbi.awaitText(ADDRESS);
      String address = line.substring(line.indexOf(ADDRESS) + ADDRESS.length());
      assertTrue(address.matches("http://localhost:\\d+/"), address);
      browser.open(address + room);
      return new StudioPage(browser, urbi, address);
    } catch (Exception | Error e) {
      urbi.close();
      throw e;
    }
  }

  /** The text of an element. */
  static String text(String selector) {
    return "return document.querySelector('" + selector + "')?.textContent";
  }

  /** Gives an input another value, as somebody does who types. */
  static String type(String selector, String value) {
    return "const field = document.querySelector('"
        + selector
        + "'); field.value = '"
        + value
        + "'; field.dispatchEvent(new Event('input'))";
  }

  @Override
  public void close() throws Exception {
    try (urbi) {
      browser.leave();
    }
  }
}
