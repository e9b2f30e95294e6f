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
    return start(Setting.in(folder), Browser.flat(), folder, program, room);
  }

  /** Likewise with a setting and browser of its own. */
  static StudioPage start(
      Setting setting, Browser browser, Path folder, String program, String room) throws Exception {
    Path file = Files.writeString(folder.resolve("program.u"), program);
    List<String> words = List.of("--studio=0", "-P", "0", "-i", "-f", file.toString());
    JavaProcess urbi = JavaProcess.start(setting, URBI, words);
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

  /** JavaScript: the row of the job under a tag. */
  static String row(String tag) {
    return "[...document.querySelectorAll('.row')]"
        + ".find(row => [...row.querySelectorAll('.chip')].some(chip => chip.textContent === '"
        + tag
        + "'))";
  }

  /**
   * What the lane of the job under a tag tells to who points at one place of it after the other:
   * the first text with a part, or else the last one.
   */
  static String told(String tag, String part) {
    return """
    const row = %s?.getBoundingClientRect();
    if (!row) return '';
    const place = document.querySelector('#lanes').getBoundingClientRect();
    const told = [];
    for (let x = Math.ceil(place.left); x < place.right; x++) {
      const there = {clientX: x, clientY: row.top + row.height / 2};
      document.querySelector('#list').dispatchEvent(new PointerEvent('pointermove', there));
      told.push(document.querySelector('#turn').textContent);
    }
    return told.find(text => text.includes('%s')) ?? told.at(-1);
    """
        .formatted(row(tag), part);
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
