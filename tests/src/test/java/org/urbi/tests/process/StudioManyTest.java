package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.StudioPage.line;
import static org.urbi.tests.process.StudioPage.value;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** More than the studio shows at a time, in a real browser: it says so, and the rest is reached. */
class StudioManyTest {
  private static final String PROGRAM =
      """
      var Global.box = Object.new|;
      for (var i : 35) { var o = Object.new| var o.x = i| box.setSlotValue("o" + i, o) }|;
      var Global.zoo = Object.new|; var Global.zoo.x = 7000|;
      var Global.calls = Object.new|;
      for (var i : 510) calls.setSlotValue("e" + i, Event.new)|;
      for& (var i : 250) { var t = Tag.new("tag_" + i)| t: sleep(1h) },
      """;

  private static final String REMARKS =
      "return [...document.querySelectorAll('.line.remark')].map(line => line.textContent).join('|')";

  @Test
  void whatIsLeftOutIsToldAndReached(@TempDir Path folder) throws Exception {
    try (StudioPage page = StudioPage.start(folder, PROGRAM, "")) {
      Browser browser = page.browser();
      findsTags(browser);
      findsEvents(browser);
      opensObjects(browser, page.urbi());
      assertTrue(!page.urbi().text().contains("internal error"), page.urbi()::text);
    }
  }

  private static void findsTags(Browser browser) throws Exception {
    String tag = "document.querySelector('[data-tag=tag_249] .tagname')";
    String last = StudioPage.text("#taglist li:last-child");
    browser.await("that there are more", last, text -> text.matches("and \\d+ more: .*"));
    assertEquals("null", browser.evaluate("return " + tag));
    browser.evaluate(StudioPage.type("#filter", "249"));
    browser.await("the tag", "return " + tag + " !== null", "true"::equals);
    String first = "return document.querySelector('#taglist li').dataset.tag";
    assertEquals("tag_249", browser.evaluate(first));
    browser.evaluate(tag + ".click()");
    assertEquals("tag_249", browser.evaluate("return document.querySelector('#filter').value"));
  }

  private static void findsEvents(Browser browser) throws Exception {
    browser.evaluate("location.hash = 'reactions'");
    String total = StudioPage.text("#event-total");
    browser.await(
        "how many there are", total, text -> text.matches("500 of 5[1-9]\\d: the filter .*"));
    String shown = "return document.querySelectorAll('#event-list li').length";
    assertEquals("500", browser.evaluate(shown));
    browser.evaluate(StudioPage.type("#reaction-filter", "e509"));
    browser.await("the last one", shown, "1"::equals);
    assertEquals("", browser.evaluate(total));
  }

  private static String open(String way) {
    return line(way) + ".querySelector('.twisty').click();";
  }

  private static void opensObjects(Browser browser, JavaProcess urbi) throws Exception {
    browser.evaluate("location.hash = 'variables'");
    browser.await("an object", "return !!" + line("Global .box"), "true"::equals);
    browser.evaluate(open("Global .box"));
    browser.await("what is in it", "return !!" + line("Global .box .o34"), "true"::equals);
    for (int i = 0; i < 35; i++) {
      browser.evaluate(open("Global .box .o" + i));
    }
    // Beside Global and the box itself there is room for thirty.
    String remark = "not shown: close others, at most 32 are open at a time";
    browser.await("what is left out", REMARKS, (remark + ("|" + remark).repeat(4))::equals);
    browser.await("the last that is shown", value("Global .box .o29 .x"), "29"::equals);
    assertEquals("false", browser.evaluate("return !!" + line("Global .box .o30 .x")));
    browser.evaluate(line("Global .box .o29 .x") + ".click()");
    urbi.send("box.o29.x = 777|;\n");
    browser.await("its value", StudioPage.text("#slot-list"), text -> text.contains("777"));
    browser.evaluate(open("Global .box .o0"));
    browser.await("one more", value("Global .box .o30 .x"), "30"::equals);
    // What is in a closed object does not count.
    browser.evaluate(open("Global .box"));
    browser.evaluate(open("Global .zoo"));
    browser.await("another object", value("Global .zoo .x"), "7000"::equals);
    assertEquals("", browser.evaluate(REMARKS));
  }
}
