package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.SimulatedRobot.awaitTruth;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.process.JavaProcess.Setting;

/**
 * All controls of the studio, in a real browser, in the hands of an observer, and of a user with a
 * telephone: each of them does something, or says why it does not. Then everything is full of what
 * has been done, and must fit the telephone.
 */
class StudioRolesTest {
  private static final String URBI = "org.urbi.server.cli.UrbiCommand";
  private static final String ADDRESS = "studio: ";
  private static final String OBSERVER = "0123456789abcdef";
  private static final String USER = "fedcba9876543210";
  private static final String FILE = "a-file-whose-name-is-longer-than-a-telephone-is-wide.u";

  private static final String PROGRAM =
      """
      var Global.n = 0|;
      var Global.heard = 0|;
      var Global.e = Event.new|;
      var Global.aVariableWithANameThatIsLongerThanATelephoneIsWide = "a text that is longer than a telephone is wide"|;
      class Global.Thing : UObject { function init() { UVar.new(this, "y") } }|;
      var Global.thing = Thing.new|;
      thing.y = 1|; thing.y->rangemin = 0|; thing.y->rangemax = 10|;
      reacting: at (e?(var what)) Global.heard = what;
      counting: every (50ms) n++,
      resting: sleep(1h),
      requireFile("urbi/sim.u")|;
      var Global.s = Simulation.new("examples/ball-tracking/table.world")|;
      s.showPage(0, nil)|;
      echo("The world has a page.")|;
      """;

  private static final String WORLD =
      "document.querySelector('#robot-frame iframe')?.contentDocument";

  private static final String ALERT = "document.querySelector('#alert')";
  private static final String SAYS_OBSERVER = "You are an observer, who sees and cannot change.";
  private static final String SAYS_USER =
      "You are a user, who cannot change what belongs to the system or to others.";

  /** What changes nothing but what is seen. */
  private static final String LOOKING =
      "#theme, #filter, #order, #span, #pause, .tagname, #reaction-filter, #reaction-order, .eventname,"
          + " #variable-filter, #slot-plot, #plot-span, #plot-pause, #plot-csv, #plotted button, #clear-log,"
          + " #robot-world, #flat";

  /** Which controls beside these can be used, also in the page of a world. */
  private static final String CHANGING =
      """
      const pages = [document, ...[...document.querySelectorAll('iframe')].map((frame) => frame.contentDocument)];
      return pages.flatMap((page) => [...page.querySelectorAll('button, input, select, textarea')])
        .filter((each) => each.checkVisibility() && !each.disabled && !each.matches('%s'))
        .map((each) => each.id || each.ariaLabel || each.textContent).join();
      """
          .formatted(LOOKING);

  private final Browser browser;

  StudioRolesTest() throws IOException {
    browser = Browser.flat();
  }

  private static Path secret(Path file, String text) throws IOException {
    Files.createFile(
        file, PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")));
    return Files.writeString(file, text);
  }

  @Test
  void eachControlDoesSomethingOrSaysWhyNot(@TempDir Path folder) throws Exception {
    Path tokens =
        secret(folder.resolve("tokens"), "observer " + OBSERVER + "\nuser " + USER + "\n");
    Path files = Files.createDirectory(folder.resolve("files"));
    Path program = Files.writeString(folder.resolve("program.u"), PROGRAM);
    Setting setting = SimulatedRobot.setting(folder);
    List<String> words =
        List.of(
            "--studio=0",
            "--tokens",
            tokens.toString(),
            "--default-role",
            "owner",
            "--max-hold",
            "0",
            "--user-directory",
            files.toString(),
            "-i",
            "-f",
            program.toString());
    try (JavaProcess urbi = JavaProcess.start(setting, URBI, words)) {
      urbi.awaitText("The world has a page.");
      String line = urbi.awaitText(ADDRESS);
      String address = line.substring(line.indexOf(ADDRESS) + ADDRESS.length());
      comeAs("observer", address + "?token=" + OBSERVER, SAYS_OBSERVER);
      observerSteersNothing();
      observerEmitsNothing();
      observerAssignsNothing();
      observerRunsNothing();
      observerDrivesNothing();
      urbi.send("[heard, thing.y, resting.frozen, s.world.paused];\n");
      urbi.awaitText("[0, 1, false, 0]");
      browser.becomeTelephone();
      comeAs("user", address + "?token=" + USER, SAYS_USER);
      userSteers();
      userEmits(urbi);
      userAssigns(urbi);
      userRuns();
      userSaves(files);
      userDrives(urbi);
      fitsTheTelephone();
      browser.becomeUsual();
      browser.leave();
      assertTrue(!urbi.text().contains("internal error"), urbi::text);
    }
  }

  private void comeAs(String role, String address, String said) throws Exception {
    browser.open(address);
    await("the role", StudioPage.text("#role"), role::equals);
    assertEquals(said, read("document.querySelector('#limit:not([hidden])')?.textContent"));
  }

  private void await(String what, String body, Predicate<String> wanted) throws Exception {
    browser.await(what, body, wanted);
  }

  private String read(String expression) throws IOException {
    return browser.evaluate("return " + expression);
  }

  private void go(String room) throws Exception {
    browser.evaluate("location.hash = '" + room + "'");
    String open = "return !!document.querySelector('[data-room=" + room + "]:not([hidden])')";
    await("the room " + room, open, "true"::equals);
  }

  private void act(String statement) throws IOException {
    browser.evaluate(statement + "; return 1");
  }

  private static String key(String element, String key, String with) {
    return element
        + ".dispatchEvent(new KeyboardEvent('keydown', {key: '"
        + key
        + "', "
        + with
        + ": true, bubbles: true, cancelable: true}))";
  }

  private static String in(String host) {
    return "document.querySelector('" + host + "').shadowRoot.querySelector('.cm-content')";
  }

  private static String button(String of, String name) {
    return "[..." + of + ".querySelectorAll('button')].find(b => b.textContent === '" + name + "')";
  }

  private static String line(String way) {
    return "[...document.querySelectorAll('.line')].find(line => line.dataset.way === '"
        + way.replace(" ", "\\n")
        + "')";
  }

  /** Does something that is to be answered by a message across the page. */
  private void tryInVain(String statement, String answer) throws Exception {
    act(ALERT + ".hidden = true");
    act(statement);
    String told = "return " + ALERT + ".hidden ? '' : " + ALERT + ".textContent";
    await("why it is not done: " + statement, told, text -> text.contains(answer));
  }

  private void nothingChanges(String room) throws IOException {
    assertEquals("", browser.evaluate(CHANGING), room);
  }

  // ------------------------------------------------------------------ an observer

  private void selectResting() throws Exception {
    await("the job", "return !!" + StudioPage.row("resting"), "true"::equals);
    act(StudioPage.row("resting") + ".click()");
    String chosen = "return !!document.querySelector('#job .buttons button')";
    await("what is told of it", chosen, "true"::equals);
  }

  private void observerSteersNothing() throws Exception {
    go("jobs");
    selectResting();
    String tags = "return document.querySelectorAll('#taglist .tagname').length > 2";
    await("the tags", tags, "true"::equals);
    nothingChanges("jobs");
    for (String key : List.of("s", "f", "Delete")) {
      tryInVain(key("document.querySelector('#list')", key, "repeat"), "needs the role");
    }
  }

  private void chooseEvent() throws Exception {
    String event = "document.querySelector('[data-event=e] button')";
    await("the event", "return !!" + event, "true"::equals);
    act(event + ".click()");
    await("that it is chosen", StudioPage.text("#emission-event"), "e"::equals);
  }

  private void observerEmitsNothing() throws Exception {
    go("reactions");
    chooseEvent();
    nothingChanges("reactions");
  }

  private void chooseSlot(String way) throws Exception {
    String parent = line("Global .thing");
    await("the object", "return !!" + parent, "true"::equals);
    if (read("!" + line(way)).equals("true")) {
      act(parent + ".querySelector('.twisty').click()");
    }
    await("the slot", "return !!" + line(way), "true"::equals);
    act(line(way) + ".click()");
    String name = way.substring(way.lastIndexOf('.') + 1);
    await("what is told of it", StudioPage.text("#slot-title"), text -> text.endsWith(name));
  }

  private void observerAssignsNothing() throws Exception {
    go("variables");
    chooseSlot("Global .thing .y");
    await("its limits", "return document.querySelector('#slot-range').hidden", "false"::equals);
    nothingChanges("variables");
    assertEquals(
        "Only an owner may record.", read("document.querySelector('#record-state').textContent"));
    tryInVain(key("document.querySelector('#variable-tree')", "Enter", "repeat"), SAYS_OBSERVER);
  }

  private void observerRunsNothing() throws Exception {
    go("code");
    await("the editor", "return !!" + in("#editor"), "true"::equals);
    nothingChanges("code");
    tryInVain(key(in("#editor"), "Enter", "ctrlKey"), SAYS_OBSERVER);
    tryInVain(key(in("#console-line"), "Enter", "repeat"), SAYS_OBSERVER);
    act(key(in("#editor"), "s", "ctrlKey"));
    String said = StudioPage.text("#file-state");
    await("why it is not saved", said, text -> text.startsWith("the role observer has no files"));
  }

  private void seesWorld() throws Exception {
    go("robot");
    String state = "return " + WORLD + "?.querySelector('#connection')?.dataset.state";
    await("the world", state, "live"::equals);
    String title = "return " + WORLD + ".querySelector('#driving').hidden";
    await("the robot", title, "false"::equals);
  }

  private String world(String element, String property) {
    return "return " + WORLD + ".querySelector('#" + element + "')." + property;
  }

  private void observerDrivesNothing() throws Exception {
    seesWorld();
    await("what it may do", world("may", "textContent"), SAYS_OBSERVER::equals);
    assertEquals("false", browser.evaluate(world("may", "hidden")));
    nothingChanges("robot");
    act(key(WORLD + ".body", "w", "repeat"));
    await("why it does not drive", world("refusal", "textContent"), SAYS_OBSERVER::equals);
    assertEquals("false", browser.evaluate(world("refusal", "hidden")));
  }

  // ------------------------------------------------------------------ a user

  private void userSteers() throws Exception {
    go("jobs");
    selectResting();
    tryInVain(
        button("document.querySelector('#job')", "Stop") + ".click()", "needs the role owner");
    tryInVain(
        button("document.querySelector('[data-tag=counting]')", "Freeze") + ".click()",
        "needs the role owner");
  }

  private void userEmits(JavaProcess urbi) throws Exception {
    go("reactions");
    chooseEvent();
    act(StudioPage.type("#payload", "7") + "; document.querySelector('#emission').requestSubmit()");
    await("what it says", StudioPage.text("#emission-result"), "e was emitted."::equals);
    awaitTruth(urbi, "it was heard", "heard == 7");
  }

  private void userAssigns(JavaProcess urbi) throws Exception {
    go("variables");
    String result = StudioPage.text("#slot-result");
    chooseSlot("Global .n");
    act(
        StudioPage.type("#slot-value", "5")
            + "; document.querySelector('#assign').requestSubmit()");
    await("why it is not done", result, text -> text.contains("needs the role owner"));
    chooseSlot("Global .thing .y");
    await("its limits", "return document.querySelector('#slot-range').hidden", "false"::equals);
    act(StudioPage.type("#slot-slider", "8"));
    await("that it is done", result, "It was assigned."::equals);
    awaitTruth(urbi, "it was assigned", "thing.y == 8");
    act("document.querySelector('#slot-plot').click()");
    await("the plot", "return document.querySelector('#plot-area').hidden", "false"::equals);
    chooseSlot("Global .aVariableWithANameThatIsLongerThanATelephoneIsWide");
    assertEquals("true", read("document.querySelector('#record').disabled"));
    assertEquals(
        "Only an owner may record.", read("document.querySelector('#record-state').textContent"));
  }

  private void write(String host, String text) throws IOException {
    act(
        in(host)
            + ".focus();"
            + key(in(host), "a", "ctrlKey")
            + "; const data = new DataTransfer(); data.setData('text/plain', `"
            + text
            + "`);"
            + in(host)
            + ".dispatchEvent(new ClipboardEvent('paste',"
            + " {clipboardData: data, bubbles: true, cancelable: true}))");
  }

  private void userRuns() throws Exception {
    go("code");
    await("the editor", "return !!" + in("#editor"), "true"::equals);
    String log = StudioPage.text("#log");
    write("#console-line", "5 + 5000;");
    act(key(in("#console-line"), "Enter", "repeat"));
    await("the value", log, text -> text.contains("] 5005"));
    write(
        "#editor",
        "6 * 7000; every (20ms) 1, // and a comment that is longer than a telephone is wide");
    act("document.querySelector('#run-code').click()");
    await("the other value", log, text -> text.contains("] 42000"));
    String runs = StudioPage.text("#runs");
    await("that it goes on", runs, text -> text.contains("goes on"));
    act("document.querySelector('#runs button:not([hidden])').click()");
    await("that it is stopped", runs, text -> !text.contains("goes on"));
    act(key(in("#editor"), "Enter", "ctrlKey"));
    await("that it goes on again", runs, text -> text.contains("goes on"));
  }

  private void userSaves(Path files) throws Exception {
    String said = StudioPage.text("#file-state");
    act("document.querySelector('#file-name').value = '" + FILE + "'");
    act("document.querySelector('#save-file').click()");
    await("that it is saved", said, text -> text.equals(FILE + " is saved"));
    Path file = files.resolve(FILE);
    assertTrue(Files.readString(file).startsWith("6 * 7000;"));
    Files.writeString(file, "theirs;");
    act(key(in("#editor"), "s", "ctrlKey"));
    await("that it is not", said, text -> text.contains("has been changed meanwhile"));
  }

  private void userDrives(JavaProcess urbi) throws Exception {
    seesWorld();
    assertEquals("true", browser.evaluate(world("may", "hidden")));
    act(key(WORLD + ".body", "w", "repeat"));
    awaitTruth(urbi, "it drives", "s.robot.body.wheel[left].val > 2");
    act(key(WORLD + ".body", "w", "repeat").replace("keydown", "keyup"));
    awaitTruth(urbi, "it stands", "s.robot.body.wheel[left].val.abs < 0.1");
    act(WORLD + ".querySelector('#pause').click()");
    awaitTruth(urbi, "it is halted", "s.world.paused");
  }

  // ------------------------------------------------------------------ a telephone

  /** Each room as the user has left it, and one more refusal. */
  private void fitsTheTelephone() throws Exception {
    for (String room : List.of("robot", "code", "variables", "reactions", "jobs")) {
      go(room);
      if (room.equals("jobs")) {
        selectResting();
        tryInVain(
            button("document.querySelector('#job')", "Stop") + ".click()", "needs the role owner");
      }
      Fit.checkForFingers(browser, room);
      Accessibility.check(browser);
      if (room.equals("robot")) {
        seesWorld();
        Accessibility.check(browser, WORLD.replace("document.q", "window.document.q"));
      }
    }
  }
}
