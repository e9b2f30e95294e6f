package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.trust.Role;

/** What the kernel calls for a client, also when it has left, leaves no jobs behind. */
class LeftHooksTest extends RolesFixture {
  private static final String CHANGES =
      "for (5) { robot.speed = robot.speed + 1; robot.plain = robot.plain + 1; robot.speed;"
          + " sleep(100ms) }; System.jobs.size;";

  @BeforeEach
  void start() {
    start(
        Kernel.builder(),
        """
        var Global.robot = Object.new|;
        var robot.speed = 1|;
        var robot.plain = 1|;
        UVar.new(robot, "speed")|;
        var Global.calls = 0|;
        var Global.called = closure () { calls += 1 }|;
        """);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "robot.&speed.notifyChange(closure () { START });",
        "robot.&speed.notifyChangeOwned(closure () { START });",
        "robot.&speed.notifyAccess(closure () { START });",
        "robot.&speed.notifyChange(closure () { 1 }); robot.&speed.notifyAccess(closure () { START });",
        "at ({ START; robot.plain > 100 }) 1;",
        "waituntil ({ START; robot.plain > 100 }),",
        "watch ({ START; robot.plain }),",
      })
  void whatAClientsCodeHasStartedEndsWithTheClient(String code) {
    String before = owner.say(CHANGES);
    user.say(code.replace("START", "detach({ sleep(inf) })") + " sleep(500ms);");
    owner.say(CHANGES);
    user.connection().close();
    assertEquals(Integer.parseInt(before) - 1, Integer.parseInt(owner.say("sleep(1s);" + CHANGES)));
  }

  /** Each has its reactions to those who leave called under its own tags. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "at sync (Lobby.onDisconnect?) START;",
        "Lobby.onDisconnect.subscribe(Subscription.new(closure (gone) { START }));",
        "at sync (Lobby.onDisconnect? if { START; true }) 1;",
      })
  void whatAClientsCodeHasStartedWhenOthersLeaveEndsWithTheClient(String code) {
    int before = Integer.parseInt(owner.say("System.jobs.size;"));
    for (Role role : new Role[] {Role.USER, Role.OWNER}) {
      TestClient client = new TestClient(kernel, role);
      client.say(code.replace("START", "detach({ called; sleep(inf) })"));
      for (Role other : Role.values()) {
        new TestClient(kernel, other).connection().close();
      }
      assertEquals("3", owner.say("sleep(1s); calls;"), role.toString());
      assertEquals(before + 4, Integer.parseInt(owner.say("System.jobs.size;")), role.toString());
      client.connection().close();
      owner.say("sleep(1s); calls = 0;");
      assertEquals(before, Integer.parseInt(owner.say("System.jobs.size;")), role.toString());
    }
  }

  /** Nobody waits for the reaction of somebody else. */
  @Test
  void whoReactsToThoseWhoLeaveHoldsUpNobody() {
    user.say("at sync (Lobby.onDisconnect?) sleep(inf);");
    owner.say("at sync (Lobby.onDisconnect?(var gone)) called;");
    new TestClient(kernel, Role.USER).connection().close();
    assertEquals("1", owner.say("sleep(1s); calls;"));
  }

  /** It ends in the same moment, and may be ending it itself. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void whoLeavesWithAnExhaustedBudgetIsReportedToOthers(boolean quits) {
    owner.say("at (Lobby.onDisconnect?(var gone)) called;");
    TestClient client = new TestClient(kernel, Role.OWNER, "jobs=5");
    client.say("disown({ at (Lobby.onDisconnect?) 1 }); for (4) detach({ sleep(inf) });");
    if (quits) {
      client.connection().send("quit;\n");
    } else {
      client.connection().close();
    }
    assertEquals("closed", client.next());
    assertEquals("1", owner.say("sleep(1s); calls;"));
  }

  /** The variable is read for who listens to it, and for nobody else. */
  @Test
  void theReadingOfAVariableEndsWithWhoListens() {
    owner.say("robot.&speed.notifyAccess(closure () { called });");
    user.say("at (robot.speed > 5) 1;");
    assertTrue(Integer.parseInt(owner.say("calls = 0 | sleep(1s) | calls;")) > 1);
    user.connection().close();
    assertEquals("0", owner.say("sleep(1s); calls = 0 | sleep(1s) | calls;"));
  }

  /** It would stay for ever, and nobody but an owner could remove it. */
  @ParameterizedTest
  @ValueSource(strings = {"notifyChange", "notifyChangeOwned", "notifyAccess"})
  void onlyOwnersHookThePrototypeOfVariables(String hook) {
    String code = "UVar." + hook + "(closure () { 1 });";
    assertRefused(user, code, hook + ": ");
    assertRefused(observer, code, hook + ": ");
    assertEquals("1", owner.say(code));
    assertEquals("1", observer.say("UVar.clone." + hook + "(closure () { 1 });"));
    assertEquals("1", observer.say("robot.&speed." + hook + "(closure () { 1 });"));
  }

  @Test
  void theHookOfAClientThatHasLeftIsStillCalled() {
    user.say("robot.&speed.notifyChange(closure () { sleep(10ms); called });");
    owner.say("robot.speed = 5; sleep(1s);");
    user.connection().close();
    owner.say("sleep(1s); robot.speed = 6; sleep(1s);");
    assertEquals("2", owner.say("calls;"));
  }

  /** Disowned, it is meant to go on, with all that it begins. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "at (robot.plain > 5) { sleep(10ms); called };",
        "whenever (robot.plain > 5) { sleep(100s); called };",
        "at (robot.plain > 5) detach({ sleep(10ms); called });",
        "{ waituntil (robot.plain > 5); sleep(10ms); called };",
        "at ((robot.plain > 5) ~ 10ms) { sleep(10ms); called };",
      })
  void theConditionOfAClientThatHasLeftStillCounts(String code) {
    user.say("disown({ " + code + " }) | sleep(1s);");
    user.connection().close();
    // Time passes quickly between statements.
    assertEquals("1", owner.say("sleep(1s); { robot.plain = 6; sleep(150s); calls };"));
  }

  /** Who may do less does not keep the kernel from reading a variable for its subscribers. */
  @Test
  void theHookOfAGuestDoesNotHoldUpTheReadingOfAVariable() {
    TestClient maker = new TestClient(kernel, Role.OWNER);
    maker.say(
        """
        robot.&speed.notifyAccess(closure () { called });
        robot.&speed.notifyChange(closure () { 1 });
        """);
    user.say("robot.&speed.notifyAccess(closure () { sleep(inf) });");
    owner.say("sleep(1s); calls = 0;");
    assertTrue(Integer.parseInt(owner.say("sleep(1s); calls;")) > 1);
  }
}
