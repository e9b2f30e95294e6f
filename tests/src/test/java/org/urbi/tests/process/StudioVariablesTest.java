package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.StudioPage.line;
import static org.urbi.tests.process.StudioPage.value;

import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The studio's room of variables, in a real browser. */
class StudioVariablesTest {
  private static final String PROGRAM =
      """
      class Global.Motor : UObject {
        function init() { UVar.new(this, "speed")| UVar.new(this, "beat") }
      }|;
      var Global.motor = Motor.new|;
      motor.speed = 0| motor.beat = 0|;
      var motor.orientation = 0|;
      motor.speed->rangemin = -10|; motor.speed->rangemax = 10|;
      var Global.x = 0|; var Global.y = 100|;
      var Global.image = Binary.new("rgb 2 1", "\\xff\\x00\\x00\\x00\\xff\\x00")|;
      var Global.sound = Binary.new("wav", "RIFF")|;
      at (motor.speed > 5) echo("fast");
      counting: every (20ms) { Global.x = (x + 1) % 50| motor.beat = x },
      """;

  private static String facts() {
    return StudioPage.text("#slot-list");
  }

  @Test
  void variablesAreBrowsedChangedAndPlottedInABrowser(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "#variables")) {
      Browser browser = page.browser();
      browser.await("a slot", value("Global .y"), "100"::equals);
      browser.evaluate(line("Global .motor") + ".querySelector('.twisty').click()");
      browser.await("a slot of an object", value("Global .motor .speed"), "0"::equals);
      readsNames(browser);
      readsOnATelephone(browser);
      assigns(browser, page.urbi());
      slides(browser, page.urbi());
      plots(browser);
      seesAnImage(browser);
      hearsASound(browser);
      records(browser, page.urbi(), folder);
      Accessibility.check(browser);
      vanishes(browser, page.urbi());
      assertEquals("true", browser.evaluate("return document.body.scrollWidth <= innerWidth"));
      assertTrue(!page.urbi().text().contains("internal error"), page.urbi()::text);
    }
  }

  /** On a small screen the types give way, not the names. */
  private static void readsNames(Browser browser) throws Exception {
    browser.becomeScreen(1000, 700);
    String cut =
        "return [...document.querySelectorAll('.line .name')]"
            + ".filter(({scrollWidth, clientWidth}) => scrollWidth > clientWidth)"
            + ".map((name) => name.textContent).join()";
    browser.await("whole names", cut, ""::equals);
    browser.becomeUsual();
  }

  /** How often and when a UVar was written has no column there, and is below its value. */
  private static void readsOnATelephone(Browser browser) throws Exception {
    browser.becomeTelephone();
    String cell = line("Global .motor .beat") + "?.children[%d]";
    String rate = cell.formatted(2);
    browser.await("its rate", "return " + rate + ".textContent", text -> !text.isEmpty());
    assertEquals("now", browser.evaluate("return " + cell.formatted(3) + ".textContent"));
    String seen =
        "return [%s, %s].every(cell => cell.checkVisibility() && cell.offsetHeight > 0)"
            .formatted(rate, cell.formatted(3));
    assertEquals("true", browser.evaluate(seen));
    String unit = "return getComputedStyle(%s, '::after').content".formatted(rate);
    assertEquals("\\\" per s\\\"", browser.evaluate(unit));
    Fit.checkForFingers(browser, "on a telephone");
    browser.becomeUsual();
  }

  private static void assigns(Browser browser, JavaProcess urbi) throws Exception {
    browser.evaluate(line("Global .y") + ".click()");
    String submit = "; document.querySelector('#assign').requestSubmit()";
    browser.evaluate(StudioPage.type("#slot-value", "20 + 1") + submit);
    browser.await("the value", value("Global .y"), "21"::equals);
    urbi.send("Global.y * 1000;\n");
    urbi.awaitText("21000");
    browser.evaluate(StudioPage.type("#slot-value", "nobody") + submit);
    String result = StudioPage.text("#slot-result");
    browser.await("what is wrong", result, t -> t.contains("lookup failed: nobody"));
    browser.await("the same value", value("Global .y"), "21"::equals);
    String alerted = "return !document.querySelector('#alert').hidden";
    assertEquals("false", browser.evaluate(alerted), "what is told below the field is told once");
  }

  private static void slides(Browser browser, JavaProcess urbi) throws Exception {
    browser.evaluate(line("Global .motor .speed") + ".click()");
    browser.await("who reads it", facts(), text -> text.contains("motor.speed > 5"));
    String written = browser.evaluate("return " + line("Global .motor .speed") + ".textContent");
    assertTrue(written.endsWith(" ago") || written.endsWith("now"), written);
    String proto = "return " + line("Global .motor :0") + ".textContent";
    assertTrue(browser.evaluate(proto).contains("Motor"), "the prototype is below the object");
    String limits = "const s = document.querySelector('#slot-slider'); return s.min + s.max";
    browser.await("its limits", limits, "-1010"::equals);
    browser.evaluate(StudioPage.type("#slot-slider", "8"));
    urbi.awaitText("fast");
    browser.await("its value", value("Global .motor .speed"), "8"::equals);
  }

  private static void plots(Browser browser) throws Exception {
    for (String way : new String[] {"Global .x", "Global .motor .speed"}) {
      browser.evaluate(line(way) + ".click()");
      browser.await(
          "that it can be plotted",
          "return slot-plot.disabled".replace("slot-plot", "document.querySelector('#slot-plot')"),
          "false"::equals);
      browser.evaluate("document.querySelector('#slot-plot').click()");
    }
    String points = "return Number(document.querySelector('#plot-area').dataset.points)";
    browser.await("samples", points, count -> Double.parseDouble(count) > 20);
    browser.await(
        "two lines",
        """
        const canvas = document.querySelector('#plot-area canvas');
        const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
        return new Set(new Uint32Array(pixels.buffer)).size;
        """,
        colours -> Integer.parseInt(colours) > 10);
    marksAreToldApart(browser);
    isZoomedByAFinger(browser);
    browser.evaluate("document.querySelector('#plot-pause').click()");
    String frozen = browser.evaluate(points);
    browser.await("later values", facts(), text -> !text.isEmpty());
    assertEquals(frozen, browser.evaluate(points));
    browser.evaluate(
        "HTMLAnchorElement.prototype.click = () => {};"
            + "URL.createObjectURL = (file) => { file.text().then(text => window.saved = text) };"
            + "document.querySelector('#plot-csv').click()");
    browser.await(
        "a file to save",
        "return window.saved",
        text -> text.matches("(?s)time,\\\\\"Global.x.*speed.*[\\d.]+,\\d+,8.*"));
    browser.evaluate("document.querySelector('#plotted button').click()");
    String plotted = "return document.querySelectorAll('#plotted li').length";
    assertEquals("1", browser.evaluate(plotted));
  }

  /** Numbers at an axis that differ little, are 0 from below, or long. */
  private static void marksAreToldApart(Browser browser) throws Exception {
    browser.evaluate(
        """
        const marks = [-0.0005, -0, 0.00025, 0.0005, 0.1 + 0.2, 1200000, 2.5e9];
        import('./plot.js').then(({shownMark}) => window.marks = marks.map(shownMark).join(' '));
        """);
    browser.await(
        "marks", "return window.marks", "-0.0005 0 0.00025 0.0005 0.3 1200000 2.5e+9"::equals);
  }

  private static void isZoomedByAFinger(Browser browser) throws Exception {
    String place =
        """
        document.querySelector('#plot-area').scrollIntoView();
        const {left, top, width, height} = document.querySelector('#plot-area .u-over').getBoundingClientRect();
        return Math.round(%s)
        """;
    int x = Integer.parseInt(browser.evaluate(place.formatted("left + width / 4")));
    int y = Integer.parseInt(browser.evaluate(place.formatted("top + height / 2")));
    String zoomed = "return document.querySelector('#plot-area').dataset.zoomed";
    assertEquals("false", browser.evaluate(zoomed));
    browser.swipe(x, y, x + 200);
    browser.await("the part between", zoomed, "true"::equals);
  }

  private static void seesAnImage(Browser browser) throws Exception {
    browser.evaluate(line("Global .image") + ".click()");
    browser.await(
        "red and green",
        """
        const canvas = document.querySelector('#slot-media canvas');
        return canvas && [...canvas.getContext('2d').getImageData(0, 0, 2, 1).data].join(' ');
        """,
        "255 0 0 255 0 255 0 255"::equals);
    String field = "const field = document.querySelector('#slot-value'); return ";
    assertEquals("rgb 2 1, 6 bytes", browser.evaluate(field + "field.placeholder + field.value"));
    assertEquals("true", browser.evaluate(field + "field.disabled"), "nobody types an image");
  }

  private static void hearsASound(Browser browser) throws Exception {
    browser.evaluate(line("Global .sound") + ".click()");
    String source = "return document.querySelector('#slot-media audio[controls]')?.src";
    browser.await("a player", source, "data:audio/wav;base64,UklGRg=="::equals);
  }

  private static void records(Browser browser, JavaProcess urbi, Path folder) throws Exception {
    String button = "document.querySelector('#record')";
    String state = StudioPage.text("#record-state");
    browser.evaluate(button + ".click()");
    String said = browser.await("a recording", state, text -> text.startsWith("records to "));
    Path file = folder.resolve(said.substring("records to ".length()));
    assertEquals("Stop recording", browser.evaluate(StudioPage.text("#record")));
    urbi.send("motor.speed = 7;\n");
    browser.await("what is recorded", value("Global .motor .speed"), "7"::equals);
    browser.evaluate(button + ".click()");
    browser.await("its end", state, text -> text.endsWith(" has ended"));
    String bytes = Files.readString(file, StandardCharsets.ISO_8859_1);
    String magic = "\u0089MCAP0\r\n";
    assertTrue(bytes.startsWith(magic) && bytes.endsWith(magic), "it is complete");
    assertTrue(bytes.contains("/motor/speed"), bytes);
    downloads(browser, file);
  }

  private static void downloads(Browser browser, Path file) throws Exception {
    browser.evaluate(
        "HTMLAnchorElement.prototype.click = function () { window.offered = this.href };"
            + "document.querySelector('#recordings button').click()");
    String address =
        browser.await("an address", "return window.offered", text -> text.contains("/download/"));
    try (InputStream content = URI.create(address).toURL().openStream()) {
      assertArrayEquals(Files.readAllBytes(file), content.readAllBytes());
    }
  }

  private static void vanishes(Browser browser, JavaProcess urbi) throws Exception {
    urbi.send("Global.removeLocalSlot(\"motor\")|;\n");
    browser.await("that it is gone", "return !!" + line("Global .motor"), "false"::equals);
    browser.await("all others", value("Global .y"), "21"::equals);
  }
}
