package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What users and observers leave where an owner comes by, to have done what they may not do:
 * functions of the library, and functions of the owner, which have the rights of their caller.
 */
class BorrowedRightsTest extends RolesFixture {

  /** What an owner's program does all day. */
  private static final String DAY =
      """
      robot.speed = 7;
      robot.plain = 7;
      robot.speed;
      robot.task;
      robot.computed;
      robot.computed = 1;
      robot.log.sort;
      robot.asString;
      robot.task(System);
      started!;
      robot.&speed.val;
      sleep(1s);
      robot.speed = 8;
      """;

  @BeforeEach
  void start() {
    start(
        Kernel.builder(),
        """
        var Global.robot = Object.new|;
        var robot.speed = 1|;
        UVar.new(robot, "speed")|;
        var robot.plain = 1|;
        var robot.computed = 1|;
        var robot.log = []|;
        var Global.started = Event.new|;
        function Global.breakIn() { var Global.broken = 1 }|;
        function robot.service() { var Global.broken = 1 }|;
        var Global.map = closure (var f) { [System].map(f) }|;
        """);
  }

  @AfterEach
  void stop() {
    assertEquals("false", owner.say("Global.hasLocalSlot(\"broken\");"));
  }

  /** The ways to get hold of a function without calling it. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "System.getSlot(\"shutdown\")",
        "System.getSlotValue(\"shutdown\")",
        "System.getLocalSlot(\"shutdown\")",
        "System.&shutdown",
        "System.getSlotValue(\"shutdown\").clone",
        "Global.methodToFunction(\"shutdown\")",
        "robot.bounce(\"shutdown\")",
        "Global.getSlotValue(\"breakIn\")",
        "Global.&breakIn",
        "Global.getSlotValue(\"breakIn\").clone",
        "robot.getSlotValue(\"service\")",
        "Global.methodToFunction(\"breakIn\")",
        "{ var o = Object.new | o.addProto(System) | o.copySlot(\"shutdown\", \"x\") | o.&x }",
        "{ var o = Object.new | o.addProto(System) | o.overrideSlot(\"shutdown\", 1) |"
            + " o.getSlotValue(\"shutdown$old\") }",
        "{ var o = Object.new | o.addProto(System) | o.cloneSlot(\"shutdown\", \"x\") | o.&x }",
      })
  void whatAUserTakesHasNoRightsOfWhoCallsIt(String taken) {
    user.say("var robot.task = " + taken + "|;");
    owner.say(DAY);
    assertEquals("\"alive\"", owner.say("\"alive\";"));
    assertEquals("true", owner.say("robot.hasLocalSlot(\"task\");"));
  }

  /** Where to leave it. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "robot.setSlot(\"task\", FUNCTION);",
        "var robot.asString = FUNCTION;",
        "robot.plain = FUNCTION; var robot.task = robot.&plain;",
        "robot.plain->updateHook = FUNCTION;",
        "robot.setProperty(\"plain\", \"updateHook\", FUNCTION);",
        "robot.computed->get = FUNCTION;",
        "robot.computed->set = FUNCTION;",
        "robot.speed = FUNCTION;",
        "robot.&speed.val = FUNCTION;",
        "robot.&speed.valsensor = FUNCTION;",
        "robot.&speed.notifyChange(FUNCTION);",
        "robot.&speed.notifyChangeOwned(FUNCTION);",
        "robot.&speed.notifyAccess(FUNCTION);",
        "started.subscribe(Subscription.new(FUNCTION));",
        "var robot.task = Lazy.new(FUNCTION);",
        "var a = Object.new|; a.setSlot(\"<\", FUNCTION); robot.log << a << 1 << a;",
        "class Trap { var '<' = FUNCTION }|; robot.log << Trap.new << 1 << Trap.new;",
        "map(FUNCTION);",
      })
  void whatAUserLeavesHasNoRightsOfWhoComesBy(String trap) {
    for (String taken :
        new String[] {"System.getSlotValue(\"shutdown\")", "Global.getSlotValue(\"breakIn\")"}) {
      user.say(trap.replace("FUNCTION", taken));
    }
    owner.say(DAY);
    assertEquals("\"alive\"", owner.say("\"alive\";"));
  }

  @Test
  void functionsThatSendAMessageHaveTheRightsOfWhoMadeThem() {
    for (String made :
        new String[] {"methodToFunction(\"shutdown\")", "robot.bounce(\"shutdown\")"}) {
      user.say(
          "{ var a = Object.new | a.setSlot(\"<\", " + made + ") | robot.log << a << a << a };");
    }
    owner.say(DAY);
    assertRefused(user, "map(methodToFunction(\"shutdown\"));", NEEDS_OWNER + "user");
    assertEquals("\"alive\"", owner.say("\"alive\";"));
  }

  @Test
  void anObserversHooksHaveTheRightsOfAnObserver() {
    observer.say("robot.&speed.notifyChange(System.getSlotValue(\"shutdown\"));");
    observer.say("robot.&speed.notifyChange(Global.getSlotValue(\"breakIn\"));");
    observer.say("robot.&speed.notifyChange(closure () { robot.plain = 99 });");
    owner.say(DAY);
    assertEquals("7", owner.say("robot.plain;"));
  }

  /** The virtual machine hands over what it has collected when it likes to. */
  @Test
  void whatIsFinalizedHasTheRightsOfWhoMadeIt() {
    observer.say(
        "var f = Finalizable.new|; f.setSlot(\"finalize\", System.getSlotValue(\"shutdown\"))|;");
    observer.say("detach({ sleep(1s); f = nil })|;");
    String answer = owner.say("sleep(2s);");
    while (!answer.contains("!!! ")) {
      System.gc();
      answer = owner.say("0;");
    }
    assertTrue(answer.contains(NEEDS_OWNER + "observer"), answer);
    owner.say(
        """
        var Global.resource = Finalizable.new|;
        function resource.finalize() { robot.plain = 5 }|;
        detach({ sleep(1s); Global.resource = nil })|;
        """);
    observer.say("sleep(2s);");
    while (!observer.say("robot.plain;").equals("5")) {
      System.gc();
    }
  }

  @Test
  void lazyFunctionsOfAnObserverHaveNoRightsOfAUser() {
    observer.say("var lobby.trap = function { robot.plain = 99 }|;");
    observer.say("var lobby.snare = lobby.&trap|;");
    for (String trap : new String[] {"l.trap(1)", "l.snare(1)", "l.&trap.apply([l])"}) {
      assertRefused(
          user,
          "for (var l : Lobby.instances) if (l.hasLocalSlot(\"trap\")) " + trap + ";",
          "this lobby has the role observer");
    }
    assertEquals("1", owner.say("robot.plain;"));
  }

  /**
   * What stands in the call has the rights of the caller, unless the function's writer may do less.
   */
  @Test
  void lazyFunctionsOfAnOwnerEvaluateArgumentsWithTheRightsOfTheCaller() {
    owner.say("var Global.echoing = function { call.evalArgs[0] }|;");
    assertRefused(user, "echoing(shutdown);", NEEDS_OWNER + "user");
    assertEquals("3", observer.say("echoing(1 + 2);"));
    assertEquals("3", user.say("echoing(1 + 2);"));
  }

  @Test
  void theLibrarysOwnCodeIsNotThatOfItsFirstCaller() {
    assertEquals("[\"a\", \"b\"]", observer.say("\"ab\".asList;"));
    owner.say("var s = \"ab\"|; function s.split(var by) { getenv(\"HOME\") | 1 }|;");
    assertEquals("1", owner.say("s.asList;"));
  }

  @Test
  void whatIsTakenWorks() {
    assertEquals("[1, 2, 3]", user.say("[3, 1, 2].getSlotValue(\"sort\").apply([[3, 1, 2]]);"));
    assertEquals("[1, 2, 3]", observer.say("List.&sort.apply([[3, 1, 2]]);"));
    assertEquals("true", user.say("System.&shutdown.isA(Primitive);"));
    assertEquals("true", user.say("robot.&service.isA(Code);"));
    assertEquals("true", user.say("robot.&service == robot.&service;"));
    assertEquals(
        "3",
        user.say("var add = function (var a, var b) { a + b }|; lobby.&add.apply([1, 1, 2]);"));
    assertEquals("[1, 4]", user.say("[1, 2].map(function (var x) { x * x });"));
    // An owner has the function itself.
    assertEquals("true", owner.say("System.&shutdown === System.getSlotValue(\"shutdown\");"));
    assertEquals("true", owner.say("robot.&service === robot.getSlotValue(\"service\");"));
  }
}
