package org.urbi.tests.process;

import java.io.IOException;

/** An editor of the studio's room of code, which is in a tree of its own below an element. */
final class StudioEditor {
  /** The one for files. */
  static final String EDITOR = "#editor";

  /** The line below the console. */
  static final String CONSOLE = "#console-line";

  private StudioEditor() {}

  /** JavaScript: an element in the editor below an element of the page. */
  static String in(String host, String selector) {
    return "document.querySelector('" + host + "')?.shadowRoot?.querySelector('" + selector + "')";
  }

  /** The text of an element in the editor. */
  static String text(String host, String selector) {
    return "return " + in(host, selector) + "?.textContent";
  }

  /** JavaScript that presses a key, maybe with Ctrl. */
  static String press(String host, String key, boolean control) {
    return press(host, key, control ? "ctrlKey" : "repeat");
  }

  /** JavaScript that presses a key with another one. */
  static String press(String host, String key, String with) {
    return in(host, ".cm-content")
        + ".dispatchEvent(new KeyboardEvent('keydown', {key: '"
        + key
        + "', "
        + with
        + ": true, bubbles: true, cancelable: true}));";
  }

  /**
   * Puts a text in the place of all, from the clipboard.
   *
   * @param text in which JavaScript fills in what is between <code>${</code> and <code>}</code>
   */
  static void write(Browser browser, String host, String text) throws IOException {
    browser.evaluate(
        in(host, ".cm-content")
            + ".focus();"
            + press(host, "a", true)
            + "const data = new DataTransfer(); data.setData('text/plain', `"
            + text
            + "`);"
            + in(host, ".cm-content")
            + ".dispatchEvent(new ClipboardEvent('paste',"
            + " {clipboardData: data, bubbles: true, cancelable: true}))");
  }
}
