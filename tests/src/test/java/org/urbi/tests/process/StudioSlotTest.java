package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.StudioPage.line;
import static org.urbi.tests.process.StudioPage.value;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The selected slot in the studio, in a real browser: what is shown of it, and assigned. */
class StudioSlotTest {
  private static final char RIGHT = '\ue014';

  /** The gain goes back to 0 by itself, as a motor that is too weak does. */
  private static final String PROGRAM =
      """
      var Global.exact = 3.14159265358979|;
      var Global.large = 1234567.891|;
      var Global.angles = [3.14159265358979, 2]|;
      var Global.left = 1|; left->rangemin = -10|; left->rangemax = 10|;
      var Global.right = 2|; right->rangemin = -10|; right->rangemax = 10|;
      var Global.gain = 0|; gain->rangemin = 0|; gain->rangemax = 20|;
      lagging: every (20ms) { if (gain > 0.25) { echo("steered") }| Global.gain = 0 },
      """;

  private static final String FIELD = "return document.querySelector('#slot-value').value";
  private static final String SUBMIT = "document.querySelector('#assign').requestSubmit()";
  private static final String SLIDER = "document.querySelector('#slot-slider')";
  private static final String POSITION = "return " + SLIDER + ".value";

  @Test
  void slotIsShownAndAssignedAsItIs(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "#variables")) {
      Browser browser = page.browser();
      browser.await("a slot", value("Global .exact"), "3.14159"::equals);
      roundsNothing(browser, page.urbi());
      slidesWhatItWasMovedFor(browser, page.urbi());
      leavesTheSliderToTheHand(browser, page.urbi());
      goesThroughManySlots(browser, page.urbi());
      assertTrue(!page.urbi().text().contains("internal error"), page.urbi()::text);
    }
  }

  /** Who presses Enter in what is shown assigns the same value. */
  private static void roundsNothing(Browser browser, JavaProcess urbi) throws Exception {
    for (String[] each : new String[][] {{"exact", "3.14159265358979"}, {"large", "1234567.891"}}) {
      browser.evaluate(line("Global ." + each[0]) + ".click()");
      browser.await("all digits", FIELD, each[1]::equals);
      browser.evaluate(SUBMIT);
      browser.await(
          "that it was assigned", StudioPage.text("#slot-result"), "It was assigned."::equals);
    }
    urbi.send("[exact == 3.14159265358979, large == 1234567.891, 1];\n");
    urbi.awaitText("[true, true, 1]");
    browser.evaluate(line("Global .angles") + ".click()");
    String shown = "return document.querySelector('#slot-value').placeholder";
    browser.await("rounded numbers", shown, "[3.14159…, 2]"::equals);
    assertEquals("", browser.evaluate(FIELD));
  }

  /** The next slot is selected before the last position of the slider has been told. */
  private static void slidesWhatItWasMovedFor(Browser browser, JavaProcess urbi) throws Exception {
    browser.evaluate(line("Global .left") + ".click()");
    browser.await("its value", POSITION, "1"::equals);
    browser.evaluate(
        StudioPage.type("#slot-slider", "8") + ";" + line("Global .right") + ".click()");
    browser.await("its new value", value("Global .left"), "8"::equals);
    browser.await("the value of the other", POSITION, "2"::equals);
    urbi.send("[left, right, 3];\n");
    urbi.awaitText("[8, 2, 3]");
  }

  private static void awaitViews(Browser browser, int count) throws Exception {
    String time = StudioPage.text("#time");
    for (int i = 0; i < count; i++) {
      String before = browser.evaluate(time);
      browser.await("a view", time, now -> !now.equals(before));
    }
  }

  private static void leavesTheSliderToTheHand(Browser browser, JavaProcess urbi) throws Exception {
    browser.evaluate(line("Global .gain") + ".click()");
    String most = "return " + SLIDER + ".max";
    browser.await("its limits", most, "20"::equals);
    browser.evaluate(SLIDER + ".focus()");
    for (int step = 1; step <= 3; step++) {
      browser.press(RIGHT);
      awaitViews(browser, 2);
      assertEquals("0." + step, browser.evaluate(POSITION));
    }
    urbi.awaitText("steered");
    browser.evaluate(SLIDER + ".blur()");
    browser.await("where the gain is", POSITION, "0"::equals);
  }

  /** An arrow key that is held goes through more slots in a second than one may ask about. */
  private static void goesThroughManySlots(Browser browser, JavaProcess urbi) throws Exception {
    browser.evaluate(
        """
        const press = (key) => document.querySelector('#variable-tree').dispatchEvent(new KeyboardEvent('keydown', {key}));
        for (let i = 0; i < 500; i++) press(i % 2 ? 'ArrowUp' : 'ArrowDown');
        """
            + line("Global .exact")
            + ".click()");
    browser.await("the slot", FIELD, "3.14159265358979"::equals);
    awaitViews(browser, 4);
    urbi.send("Global.exact = 4|;\n");
    browser.await("its value", FIELD, "4"::equals);
    String connections = "return document.querySelector('#connection').dataset.connections";
    assertEquals("1", browser.evaluate(connections));
  }
}
