package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.trust.Role;

/** What clients that have left leave behind has one budget in common. */
class DepartedClientsTest {
  private final List<String> log = new CopyOnWriteArrayList<>();
  private final Kernel kernel =
      Kernel.builder().log(log::add).logLevel(LogLevel.LOG).virtualTime(true).start();
  private final TestClient judge = new TestClient(kernel, Role.OWNER);

  @AfterEach
  void close() {
    kernel.close();
  }

  /** A client with a budget; what it is told does not matter. */
  private TestClient visitor(String budget) {
    return new TestClient(kernel, Role.OWNER, budget);
  }

  private void leave(TestClient client) {
    client.connection().close();
    judge.say("sleep(1ms);");
  }

  private void visit(String budget, String program) {
    TestClient client = visitor(budget);
    client.say(program);
    leave(client);
  }

  private int jobs() {
    judge.say("sleep(2ms);");
    return Integer.parseInt(judge.say("System.jobs.size;"));
  }

  private List<String> endings() {
    List<String> told = new ArrayList<>();
    for (String line : log) {
      told.add(line.replaceFirst("Lobby_\\d+", "Lobby"));
    }
    return told;
  }

  private static final String ENDED =
      "urbi: clients that have left may have 100 jobs together: ending what Lobby has left behind, ";

  private static String sleepers(int count) {
    return "for (" + count + ") disown({ sleep(inf) });";
  }

  @Test
  void whatOneClientLeavesBehindGoesOn() {
    visit("jobs=100", sleepers(50));
    assertEquals(51, jobs());
    assertEquals(List.of(), endings());
  }

  @Test
  void whatIsTooMuchForAllEnds() {
    visit("jobs=100", sleepers(90));
    for (int i = 0; i < 20; i++) {
      visit("jobs=100", sleepers(80));
      assertTrue(jobs() <= 101, "too many");
    }
    assertEquals(20, endings().size());
    assertEquals(ENDED + "90 jobs", endings().getFirst(), "the most");
    assertEquals(ENDED + "80 jobs", endings().getLast(), "the newest");
  }

  @Test
  void whoeverLeavesLittleKeepsIt() {
    judge.say("var Global.beats = 0;");
    visit("jobs=100", "disown({ every (1ms) { Global.beats = Global.beats + 1 } })|;");
    for (int i = 0; i < 5; i++) {
      visit("jobs=100", "for (90) disown({ loop {} });");
    }
    judge.say("Global.beats = 0 | sleep(5ms);");
    assertTrue(Integer.parseInt(judge.say("Global.beats;")) >= 4, judge.say("Global.beats;"));
    assertEquals(4, endings().size(), "the first one leaves no more than it may");
  }

  @Test
  void jobsThatAreEndingDoNotCount() {
    visit("jobs=100", sleepers(20));
    visit("jobs=100", "for (90) detach({ sleep(inf) }); disown({ sleep(inf) })|;");
    assertEquals(22, jobs());
    assertEquals(List.of(), endings());
  }

  /** A job that is ended may still wait in its finally clause. */
  @Test
  void jobsThatDoNotEndCountInTheEnd() {
    for (int i = 0; i < 20; i++) {
      visit(
          "jobs=100",
          "for (80) detach({ try { sleep(inf) } finally { loop { sleep(inf) } } }); sleep(1s);");
    }
    judge.say("sleep(2s);");
    visit("jobs=100", "1|;");
    assertTrue(jobs() <= 182, judge.say("System.jobs.size;"));
  }

  @Test
  void handlersEndWithTheJobsThatHaveSetThem() {
    judge.say("var Global.told = 0; var Global.e = Event.new;");
    String handler = "disown({ at (Global.e?) { Global.told = Global.told + 1 } })|; sleep(1s);";
    visit("jobs=100", handler + sleepers(90));
    judge.say("Global.e!; sleep(1s);");
    assertEquals("1", judge.say("Global.told;"));
    visit("jobs=100", sleepers(80));
    judge.say("sleep(2s); Global.e!; sleep(1s);");
    assertEquals("1", judge.say("Global.told;"));
  }

  @Test
  void lobbiesThatItHasMadeEndToo() {
    visit(
        "jobs=100",
        "var Global.made = Lobby.create|; made.receive(\"for (80) detach({sleep(inf)});\");sleep(1s);");
    judge.say("sleep(2s);");
    visit("jobs=100", sleepers(70));
    assertEquals(71, jobs());
  }

  /** They are closed with the client, so that only its budget knows of them. */
  @ParameterizedTest
  @CsvSource({
    "OWNER, for (80) detach({ try { sleep(inf) } finally { loop { sleep(inf) } } })",
    "USER, for (80) detach({ try { sleep(inf) } finally { loop { sleep(inf) } } })",
    "OWNER, for& (80) { try { sleep(inf) } finally { loop { sleep(inf) } } }",
    "USER, for& (80) { try { sleep(inf) } finally { loop { sleep(inf) } } }",
    "OWNER, for (80) disown({ sleep(inf) })",
    "USER, for (80) disown({ sleep(inf) })",
  })
  void whatIsLeftOfLobbiesThatItHasMadeEndsToo(Role role, String left) {
    TestClient client = new TestClient(kernel, role, "jobs=100");
    client.say(
        "var made = Lobby.create|; made.receive(\""
            + left
            + ";\"); sleep(1s); made.quit; sleep(1s);");
    leave(client);
    judge.say("sleep(2s);");
    visit("jobs=100", sleepers(30));
    judge.say("sleep(2s);");
    visit("jobs=100", "1|;");
    assertEquals(31, jobs());
  }

  /** The lobbies that it has made have its budget. */
  @Test
  void whoeverIsEvictedEndsInAllItsLobbies() {
    TestClient client = visitor("jobs=100");
    client.say(
        """
        var made = Lobby.create|;
        made.receive("for (10) detach({ sleep(inf) });");
        var over = Lobby.create|;
        over.receive("for (10) detach({ try { sleep(inf) } finally { loop { sleep(inf) } } });");
        sleep(1s); over.quit; sleep(1s);
        """);
    assertEquals(23, jobs());
    ((KernelConnection) client.connection()).evict("too much");
    judge.say("sleep(1s);");
    assertEquals(3, jobs());
    client.say("made.receive(\"detach({ sleep(inf) });\");");
    assertEquals(4, jobs(), "it may go on");
  }

  /** Functions that they have hooked onto variables are called when they have left. */
  @Test
  void whatIsCalledForThemLaterIsInTheCommonBudget() {
    judge.say(
        """
        var Global.robot = Object.new|;
        var robot.speed = 1|;
        UVar.new(robot, "speed")|;
        """);
    for (int i = 0; i < 30; i++) {
      TestClient client = new TestClient(kernel, Role.USER, "jobs=20");
      client.say(
          "robot.&speed.notifyChange(closure () { for (9) detach({ sleep(inf) }); wait });"
              .replace("wait", "sleep(inf)"));
      leave(client);
      judge.say("sleep(2s);");
    }
    for (int i = 0; i < 3; i++) {
      judge.say("robot.speed = robot.speed + 1; sleep(2s);");
      assertTrue(jobs() <= 21, judge.say("System.jobs.size;"));
    }
    assertEquals(2, kernel.departed().all().size());
  }

  @Test
  void nothingIsKeptOfWhatHasEnded() {
    judge.say("var Global.go = Event.new;");
    visit("jobs=100", "for (50) disown({ waituntil (Global.go?) });");
    assertEquals(1, kernel.departed().all().size());
    judge.say("Global.go!; sleep(1s);");
    assertEquals(0, kernel.departed().all().size());
    for (int i = 0; i < 10; i++) {
      visit("jobs=100", sleepers(80));
      jobs();
    }
    assertEquals(1, kernel.departed().all().size());
  }

  /** It does let others run, so that nothing needs to end it at once. */
  @Test
  void whatRunsWhenItsClientLeavesGoesOn() {
    judge.say("var Global.beats = 0;");
    for (int i = 0; i < 10; i++) {
      visit("", "disown({ loop { Global.beats = Global.beats + 1 } })|;");
      assertEquals(i + 2, jobs());
    }
  }

  @Test
  void whatHoldsTheKernelWhenItsClientLeavesEnds() {
    TestClient holding = visitor("");
    holding.connection().send("disown({ while| (true) {} })|;\n");
    holding.connection().close();
    assertEquals(1, jobs());
  }

  /** Neither does what begins to hold it later, when no request to leave is left. */
  @Test
  void whatHoldsTheKernelAfterItsClientHasLeftEnds() {
    judge.say("var Global.go = Event.new;");
    TestClient holding = visitor("");
    holding.say("disown({ waituntil (Global.go?); while| (true) {} })|;");
    leave(holding);
    assertEquals(2, jobs());
    judge.say("Global.go!;");
    assertEquals(1, jobs());
  }

  /** The statement obeys the request to leave; what it has detached begins in the same tick. */
  @Test
  void whatBeginsToHoldTheKernelBeforeItIsKnownThatItsClientLeavesEnds() {
    // In simulated time a program that has defined a function would have to let the time go by.
    try (Kernel real = Kernel.builder().start()) {
      TestClient observer = new TestClient(real, Role.OWNER);
      TestClient holding = new TestClient(real, Role.OWNER);
      real.define(
          "leaveNow",
          nothing -> {
            holding.connection().close();
            return null;
          });
      holding.connection().send("disown({ while| (true) {} }) | leaveNow | loop| {};\n");
      assertEquals(
          "1", observer.say("while (System.jobs.size != 1) sleep(2ms); System.jobs.size;"));
    }
  }

  @Test
  void whatIsLeftBehindCannotLiftItsLimit() {
    judge.say("var Global.go = Event.new; var Global.before = 0;");
    TestClient holding = visitor("");
    holding.say(
        "disown({ waituntil (Global.go?); Global.before = lobby.budget(\"hold\");"
            + " lobby.setBudget(\"hold\", inf); while| (true) {} })|;");
    leave(holding);
    judge.say("Global.go!;");
    assertEquals(1, jobs());
    assertEquals("inf", judge.say("Global.before;"), "programs do not see it");
  }
}
