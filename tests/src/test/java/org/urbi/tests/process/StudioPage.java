package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
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
    JavaProcess urbi = serve(setting, "0", "-f", file.toString());
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

  /**
   * Starts a server alone.
   *
   * @param port of its studio; 0 for any
   */
  static JavaProcess serve(Setting setting, String port, String... more) throws IOException {
    List<String> words = new ArrayList<>(List.of("--studio=" + port, "-P", "0", "-i"));
    words.addAll(List.of(more));
    return JavaProcess.start(setting, URBI, words);
  }

  /** The port of its studio. */
  String port() {
    return address.replaceAll("\\D", "");
  }

  /** A file that tells who is let in, as the server asks for it: for nobody else's eyes. */
  static String tokens(Path folder, String lines) throws IOException {
    Set<PosixFilePermission> secret = PosixFilePermissions.fromString("rw-------");
    Path file =
        Files.createFile(folder.resolve("tokens"), PosixFilePermissions.asFileAttribute(secret));
    return Files.writeString(file, lines).toString();
  }

  /** The text of an element. */
  static String text(String selector) {
    return "return document.querySelector('" + selector + "')?.textContent";
  }

  /** JavaScript: the line of the slot at the end of a way whose steps are separated by blanks. */
  static String line(String way) {
    return "[...document.querySelectorAll('.line')].find(line => line.dataset.way === '"
        + way.replace(" ", "\\n")
        + "')";
  }

  /** The value in that line. */
  static String value(String way) {
    return "return " + line(way) + "?.querySelector('.value').textContent";
  }

  /** JavaScript: the rows of the jobs under a tag that match a selector, one after the other. */
  static String rows(String tag, String selector) {
    return "[...document.querySelectorAll('.row"
        + selector
        + "')].filter(row => [...row.querySelectorAll('.chip')].some(chip => chip.textContent === '"
        + tag
        + "'))";
  }

  /** JavaScript: the row of the job under a tag that has not ended. */
  static String row(String tag) {
    return rows(tag, ":not(.ended)") + "[0]";
  }

  /**
   * JavaScript: a function that makes a row into what its lane tells to who points at one place of
   * it after the other, a letter for each: r where it ran, ? where nobody has looked, . behind its
   * end, else the first one of what it waited for.
   */
  static final String LANE =
      """
      const lane = (row) => {
        const {top, height} = row.getBoundingClientRect();
        const {left, right} = document.querySelector('#lanes').getBoundingClientRect();
        let told = '';
        for (let x = Math.ceil(left); x < right; x++) {
          document.querySelector('#list').dispatchEvent(new PointerEvent('pointermove', {clientX: x, clientY: top + height / 2}));
          const text = document.querySelector('#turn').textContent.replace(/^\\w+: (waits for )?/, '');
          told += text.startsWith('was not') ? '?' : text.startsWith('has ended') ? '.' : text[0];
        }
        return told;
      };
      """;

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
