package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.SimulatedRobot.awaitTruth;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.process.JavaProcess.Setting;

/** The studio's room of the robot, in a real browser that draws in three dimensions. */
class StudioRobotTest {
  private static final String PROGRAM =
      """
      requireFile("urbi/sim.u")|;
      var Global.s = Simulation.new("examples/ball-tracking/table.world")|;
      var Global.pitch = s.robot.body.neck.head.pitch|;
      pitch.val = -0.6|;
      s.showPage(0, nil)|;
      echo("The world has a page.")|;
      """;

  /** JavaScript: the page of the world, within the one of the studio. */
  private static final String WORLD =
      "const view = document.querySelector('#robot-frame iframe')?.contentWindow;"
          + "const find = (name) => view?.document.querySelector('#' + name);";

  private static final String STATE = WORLD + "return find('connection')?.dataset.state";

  /**
   * How far from the top of the picture is what marks the view of the camera in the head, on
   * average, in pixels; nothing of it is 0.
   */
  private static final String HEIGHT_OF_VIEW =
      WORLD
          + """
          const space = find('space');
          if (!space || space.hidden || !space.dataset.time) return 0;
          const copy = document.createElement('canvas');
          [copy.width, copy.height] = [space.width, space.height];
          const pen = copy.getContext('2d');
          pen.drawImage(space, 0, 0);
          const pixels = new Uint32Array(pen.getImageData(0, 0, copy.width, copy.height).data.buffer);
          const rows = [];
          pixels.forEach((each, i) => each === 0xff00b3ff && rows.push(Math.floor(i / copy.width)));
          return rows.reduce((a, b) => a + b, 0) / (rows.length || 1);
          """;

  private static double number(String text) {
    return text.equals("undefined") ? 0 : Double.parseDouble(text);
  }

  private static void go(Browser browser, String room) throws Exception {
    browser.evaluate("location.hash = '" + room + "'");
    String open = "return !!document.querySelector('[data-room=" + room + "]:not([hidden])')";
    browser.await("the room", open, "true"::equals);
  }

  @Test
  void robotIsSeenAndMovedFromTheStudio(@TempDir Path folder) throws Exception {
    Setting setting = SimulatedRobot.setting(folder);
    try (StudioPage page =
        StudioPage.start(setting, Browser.spatial(), folder, PROGRAM, "#robot")) {
      Browser browser = page.browser();
      page.urbi().awaitText("The world has a page.");
      browser.await("the world", STATE, "live"::equals);
      obeysAVariable(browser, page.urbi());
      showsEachSpeed(browser, page.urbi());
      tellsHowStrongAPushIs(browser);
      hasTheColoursOfTheStudio(browser);
      restsWhileNobodySeesIt(browser, page.urbi());
      assertTrue(!page.urbi().text().contains("internal error"), page.urbi()::text);
    }
  }

  /** A variable that is changed in the studio moves the head, which is seen there. */
  private static void obeysAVariable(Browser browser, JavaProcess urbi) throws Exception {
    awaitTruth(urbi, "it looks up", "pitch.val < -0.55");
    browser.await("its view", HEIGHT_OF_VIEW, height -> number(height) > 0);
    double up = number(browser.evaluate(HEIGHT_OF_VIEW));
    go(browser, "variables");
    String line =
        "[...document.querySelectorAll('.line')].find(each => each.dataset.way === 'Global\\n.pitch%s')";
    browser.await("the motor", "return !!" + line.formatted(""), "true"::equals);
    browser.evaluate(line.formatted("") + ".querySelector('.twisty').click()");
    String position = line.formatted("\\n.val");
    browser.await("its position", "return !!" + position, "true"::equals);
    browser.evaluate(position + ".click()");
    String slider = "document.querySelector('#slot-slider')";
    browser.await("its limits", "return " + slider + ".max > 0.8", "true"::equals);
    browser.evaluate(StudioPage.type("#slot-slider", "0.8"));
    browser.await(
        "that it is there",
        "return " + position + ".querySelector('.value').textContent",
        value -> Math.abs(number(value) - 0.8) < 0.03);
    go(browser, "robot");
    browser.await("that it looks down", HEIGHT_OF_VIEW, height -> number(height) > up + 3);
  }

  /** A program may give a world a speed that nobody can choose on the page. */
  private static void showsEachSpeed(Browser browser, JavaProcess urbi) throws Exception {
    String pace = WORLD + "return find('pace').value";
    String offered =
        WORLD
            + "return [...find('pace').options].filter(each => !each.hidden).map(each => each.text).join(' ')";
    assertEquals("0.1 0.5 1 2 5", browser.evaluate(offered));
    urbi.send("s.world.speed = 3;\n");
    browser.await("the speed", pace, "3"::equals);
    assertEquals("0.1 0.5 1 2 5 3", browser.evaluate(offered));
    urbi.send("s.world.speed = 1;\n");
    browser.await("the usual speed", pace, "1"::equals);
    assertEquals("0.1 0.5 1 2 5", browser.evaluate(offered));
  }

  private static void tellsHowStrongAPushIs(Browser browser) throws Exception {
    String told = WORLD + "return find('strength-told').textContent";
    assertEquals("1.0 m/s", browser.evaluate(told));
    browser.evaluate(
        WORLD + "find('strength').value = 2.5; find('strength').dispatchEvent(new Event('input'))");
    assertEquals("2.5 m/s", browser.evaluate(told));
  }

  private static void hasTheColoursOfTheStudio(Browser browser) throws Exception {
    String themes =
        WORLD
            + "return document.documentElement.dataset.theme + ' ' + view?.document.documentElement?.dataset.theme";
    String named = "return document.querySelector('#theme').ariaLabel";
    assertEquals("undefined undefined", browser.evaluate(themes));
    assertEquals("Colours as the system has them", browser.evaluate(named));
    for (String[] next : new String[][] {{"light", "Light colours"}, {"dark", "Dark colours"}}) {
      browser.evaluate("document.querySelector('#theme').click()");
      browser.await("its colours", themes, (next[0] + " " + next[0])::equals);
      assertEquals(next[1], browser.evaluate(named));
    }
    browser.evaluate("location.reload()");
    browser.await("the same colours", themes, "dark dark"::equals);
    browser.evaluate("document.querySelector('#theme').click()");
    browser.await("those of the system again", themes, "undefined undefined"::equals);
    browser.await("the world", STATE, "live"::equals);
  }

  /** Its clock is turned: nobody waits for half a minute. */
  private static void restsWhileNobodySeesIt(Browser browser, JavaProcess urbi) throws Exception {
    awaitTruth(urbi, "somebody looks", "s.page.viewers == 1");
    String hide =
        WORLD
            + """
            view.later = [];
            view.setTimeout = (act, delay) => view.later.push({act, delay});
            Object.defineProperty(view.document, 'hidden', {value: %s, configurable: true});
            view.document.dispatchEvent(new Event('visibilitychange'));
            return view.later.map(({delay}) => delay).join();
            """;
    assertEquals("30000", browser.evaluate(hide.formatted("true")));
    assertEquals("live", browser.evaluate(STATE), "who is back soon misses nothing");
    browser.evaluate(WORLD + "view.later[0].act()");
    browser.await("that it rests", STATE, "waiting"::equals);
    awaitTruth(urbi, "nobody looks", "s.page.viewers == 0");
    assertEquals("", browser.evaluate(hide.formatted("false")));
    browser.await("that it is back", STATE, "live"::equals);
    awaitTruth(urbi, "somebody is back", "s.page.viewers == 1");
  }
}
