package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.trust.Role;

/** Users and observers who listen to an owner: it neither waits for them nor ends with them. */
class GuestsTest extends RolesFixture {
  private static final String DAY =
      """
      done = 0|;
      timeout (10s) {
        started!;
        started.syncEmit;
        var lasting = started.trigger|;
        lasting.stop;
        var waited = started.syncTrigger|;
        waited.stop;
        robot.speed = 7;
        robot.plain = 7;
        robot.speed;
        done = 1
      };
      done;
      """;

  @BeforeEach
  void start() {
    start(
        Kernel.builder(),
        """
        var done = 0|;
        var Global.robot = Object.new|;
        var robot.speed = 1|;
        var robot.plain = 1|;
        UVar.new(robot, "speed")|;
        var Global.started = Event.new|;
        """);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "robot.&speed.notifyChange(closure () { HOLD });",
        "robot.&speed.notifyChangeOwned(closure () { HOLD });",
        "robot.&speed.notifyAccess(closure () { HOLD });",
        "started.subscribe(Subscription.new(closure () { HOLD }));",
        "started.onEvent(closure (var e, var p) { HOLD }, closure (var e, var p, var m) { 1 });",
        "started.onEvent(closure (var e, var p) { 1 }, closure (var e, var p, var m) { 1 },"
            + " closure (var e, var p, var m) { HOLD }, true);",
        "at sync (started?) HOLD;",
        "at sync (started?) 1 onleave HOLD;",
        "at (started?) HOLD;",
        "at (started? if { HOLD; true }) 1;",
        "whenever (started? if { HOLD; true }) 1;",
        "at ({ if (robot.plain > 1) HOLD; true }) 1;",
        "at sync (robot.plain > 1) HOLD;",
        "waituntil ({ if (robot.plain > 1) HOLD; false }),",
        "waituntil (started? if { HOLD; true }),",
        "watch ({ if (robot.plain > 1) HOLD; 1 }),",
        "at sync (robot.&speed.changed?) HOLD;",
      })
  void anOwnerWaitsForNoGuest(String guest) {
    for (String hold : new String[] {"sleep(inf)", "throw Exception.new(\"of a guest\")"}) {
      observer.say(guest.replace("HOLD", hold));
      user.say(guest.replace("HOLD", hold));
    }
    assertEquals("1", owner.say(DAY));
    assertEquals("1", owner.say(DAY));
  }

  @Test
  void guestsAreTold() {
    assertEquals(
        "",
        observer.say(
            """
            robot.&speed.notifyChange(closure () { echo("hook " + robot.speed) })|;
            at sync (started?(var x)) echo("event " + x) onleave echo("over");
            at (robot.plain > 1) echo("plain") onleave echo("no more");
            { waituntil (started?(var y)); echo("waited " + y) },
            """));
    owner.say(
        "started!(3); robot.speed = 7; robot.plain = 7; sleep(1s); robot.plain = 1; sleep(1s);");
    String told = observer.say("sleep(1ms)|;");
    for (String line : new String[] {"hook 7", "event 3", "over", "plain", "no more", "waited 3"}) {
      assertEquals(1, told.lines().filter(("*** " + line)::equals).count(), told);
    }
    owner.say("robot.speed = 8; robot.speed = 9; sleep(1s);");
    String last = observer.say("sleep(1ms)|;");
    assertEquals("*** hook 9", last.lines().toList().getLast());
    assertFalse(last.contains("!!!"), last);
  }

  @Test
  void aGuestsHookThatWritesIsNotCalledForThat() {
    user.say("robot.&speed.notifyChange(closure () { robot.speed += 1 })|;");
    owner.say("robot.speed = 7; sleep(1s);");
    assertEquals("8", owner.say("robot.speed;"));
  }

  @Test
  void whoMayDoAsMuchIsWaitedFor() {
    for (Role role : new Role[] {Role.OWNER, Role.USER}) {
      TestClient listens = new TestClient(kernel, role);
      TestClient emits = new TestClient(kernel, role);
      listens.say(
          """
          at sync (started?) robot.plain = 5;
          robot.&speed.notifyChange(closure () { robot.plain = robot.speed })|;
          """);
      assertEquals("5", emits.say("robot.plain = 1| { started!| robot.plain };"));
      assertEquals("6", emits.say("robot.plain = 1| { robot.speed = 6| robot.plain };"));
    }
    // Nor does a guest go on before what an owner does about it.
    owner.say("at sync (started?) robot.plain = 50;");
    assertEquals("50", user.say("robot.plain = 1| { started!| robot.plain };"));
  }
}
