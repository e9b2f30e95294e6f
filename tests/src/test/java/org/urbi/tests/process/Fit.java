package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;

/** Whether a page as it is now fits the screen, and fingers. */
final class Fit {
  private static final String CUT =
      """
      const wide = document.documentElement.clientWidth;
      const cut = [...document.querySelectorAll('body *')].filter((element) => {
        const {left, right, width, height} = element.getBoundingClientRect();
        return width && height && (left < -1 || right > wide + 1);
      });
      if (document.documentElement.scrollWidth > wide) cut.push(document.body);
      return cut.map((element) => element.id || element.className || element.tagName).join(' ');
      """;

  private static final String TOO_SMALL =
      """
      const small = [...document.querySelectorAll('button, select, input, a, [role=treeitem], .twisty')].filter((element) => {
        const {width, height} = element.getBoundingClientRect();
        return width && height && (width < 44 || height < 44) && !element.matches('p a');
      });
      return small.map((element) => element.id || element.className || element.textContent).join(' ');
      """;

  private Fit() {}

  /** Nothing may be cut. */
  static void check(Browser browser, String what) throws IOException {
    assertEquals("", browser.evaluate(CUT), what);
  }

  /** Nothing may be cut, and nothing too small for a finger. */
  static void checkForFingers(Browser browser, String what) throws IOException {
    check(browser, what);
    assertEquals("", browser.evaluate(TOO_SMALL), what);
  }
}
