package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.trust.Role;

/** What users and observers try on a bad day, beside an owner who must not notice. */
class RolesTest extends RolesFixture {
  @TempDir Path temporary;
  private Path files;

  @BeforeEach
  void start() throws IOException {
    files = Files.createDirectory(temporary.toRealPath().resolve("files"));
    Files.writeString(files.resolve("own"), "own");
    Files.writeString(files.resolve("../secret"), "secret");
    start(
        Kernel.builder().userDirectory(files),
        """
        var Global.robot = Object.new|;
        var robot.speed = 1|;
        var robot.log = []|;
        var Global.started = Event.new|;
        function Global.increase() { robot.speed += 1 }|;
        var Global.asOwner = closure () { robot.speed = 100 }|;
        """);
  }

  @AfterEach
  void stop() throws IOException {
    // Whatever was tried, the owner can work, and numbers can be added.
    assertEquals("3", owner.say("1 + 2;"));
    assertEquals("secret", Files.readString(files.resolve("../secret")));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "shutdown;",
        "System.shutdown(3);",
        "reboot;",
        "System._exit(1);",
        "stopall;",
        "System.system(\"true\");",
        "Process.new(\"true\", []).run;",
        "Socket.new.connect(\"localhost\", 1);",
        "Server.new.listen(\"localhost\", 0);",
        "loadModule(\"x\");",
        "System.getenv(\"HOME\");",
        "System.env[\"HOME\"];",
        "System.setenv(\"A\", \"b\");",
        "var Float.'+' = function (x) { 42 };",
        "Float.'+' = function (x) { 42 };",
        "Float.setSlot(\"x\", 1);",
        "Float.removeSlot(\"+\");",
        "Float.updateSlot(\"+\", 1);",
        "Float.overrideSlot(\"+\", 1);",
        "Float.addProto(Object.new);",
        "Float.protos = [Object.new];",
        "Object.setProtos([]);",
        "UVar.new(Float, \"+\");",
        "var u = UVar.new(lobby, \"v\")|; u.copy(Float, \"+\");",
        "Float.'+'->constant = true;",
        "var f = 1|; f.'+'->updateHook = function (n, v) { 1 };",
        "Float.setProperty(\"+\", \"a\", 1);",
        "get Float.'+'() { 42 };",
        "Float.getSlot(\"+\").setSlot(\"x\", 1);",
        "do (Float) { var x = 1 };",
        "var Global.x = 1;",
        "var Object.asString = 1;",
        "var Lobby.x = 1;",
        "var System.x = 1;",
        "true.setSlot(\"x\", 1);",
        "nil.setSlot(\"x\", 1);",
        "cout.setSlot(\"name\", \"error\");",
        "Date.init(1);",
        "Mutex.lock;",
        "var Exception.Lookup.x = 1;",
        "System.nonInterruptible;",
        "1.srandom;",
        "Math.srandom(1);",
        "Lobby.instances[1].setSlot(\"x\", 1);",
        "var Lobby.instances[1].x = 1;",
        "Lobby.instances[1].receive(\"shutdown;\");",
        "Lobby.instances[1].quit;",
        "Lobby.instances[1].echo(\"I am the system\");",
        "Lobby.instances[1].connectionTag.stop;",
        "Lobby.instances[1].connectionTag.freeze;",
        "Logger.Levels.setSlot(\"x\", 1);",
        "Logger.Levels.values << 5;",
        "Logger.Levels.Log.setSlot(\"asString\", 1);",
        "for (var j : System.jobs) j.terminate;"
      })
  void whatIsTheOwnersIsRefused(String code) {
    assertRefused(user, code, NEEDS_OWNER + "user");
    assertRefused(observer, code, "needs the role ");
  }

  @Test
  void aUserDoesWhatUsersDo() {
    assertEquals("3", user.say("var x = 1|; x += 2;"));
    assertEquals("2", user.say("robot.speed = 2;"));
    assertEquals("[7]", user.say("robot.log << 7;"));
    assertEquals("3", user.say("increase; robot.speed;").lines().toList().getLast());
    assertEquals("", user.say("class A { var v = 1; function init(w) { v = w } }|;"));
    assertEquals("5", user.say("A.new(5).v;"));
    assertEquals("*** seen", user.say("at (started?) echo(\"seen\"); started!; sleep(1ms)|;"));
    assertEquals("[1, 2]", user.say("var l = [1]|; l << 2;"));
    assertEquals("", user.say("var t = Tag.new|; t: every (1s) {},; t.stop;"));
  }

  @Test
  void aUserHasTheFilesBelowItsDirectory() throws IOException {
    assertEquals("\"own\"", user.say("File.new(\"own\").content.data;"));
    assertEquals("\"own\"", user.say("File.new(\"" + files + "/own\").content.data;"));
    assertEquals("", user.say("File.save(\"new\", \"text\");"));
    assertEquals("text", Files.readString(files.resolve("new")));
    for (String path : new String[] {"../secret", files + "/../secret", "/etc/passwd"}) {
      String quoted = "\"" + path + "\"";
      assertRefused(user, "File.new(" + quoted + ");", "outside of the directory");
      assertRefused(user, "InputStream.new(File.new(" + quoted + "));", "outside of");
      assertRefused(user, "File.save(" + quoted + ", \"x\");", "outside of the directory");
      assertRefused(user, "System.loadFile(" + quoted + ");", "");
    }
    assertRefused(user, "Directory.new(\"..\").removeAll;", "outside of the directory");
    assertRefused(user, "File.new(\"own\").copy(\"../copy\");", "outside of the directory");
    assertFalse(Files.exists(files.resolve("../copy")));
    assertRefused(user, "Path.cd(\"/\");", NEEDS_OWNER);
    assertRefused(observer, "File.new(\"own\").content;", "needs the role user");
  }

  @Test
  void anObserverReadsAndSubscribesAndChangesNothing() {
    assertEquals("1", observer.say("robot.speed;"));
    assertEquals("2", observer.say("var x = 1|; x + 1;"));
    assertEquals("\"[1, 3, 4]\"", observer.say("[3, 1, 4].sort.asString;"));
    assertEquals(
        "*** now 5",
        observer.say("at (robot.speed > 4) echo(\"now \" + robot.speed);") + tellAndListen());
    for (String code :
        new String[] {
          "robot.speed = 2;",
          "var robot.other = 2;",
          "robot.removeSlot(\"speed\");",
          "robot.log << 1;",
          "robot.log.clear;",
          "started!;",
          "increase;",
          "robot.speed->rangemin = 1;",
          "lobby.wall(\"x\");",
        }) {
      assertRefused(observer, code, "needs the role user, and this lobby has the role observer");
    }
    assertEquals("5", owner.say("robot.speed;"));
  }

  private String tellAndListen() {
    owner.say("robot.speed = 5|;");
    return observer.say("sleep(1ms)|;");
  }

  @Test
  void anObserverUsesWhatItMakes() {
    assertEquals("", observer.say("class A { var v = 1; function init(w) { v = w } }|;"));
    assertEquals("5", observer.say("A.new(5).v;"));
    assertEquals("", observer.say("var t = Tag.new|; t: every (1s) {},; t.stop;"));
    assertEquals(
        "\"a\"", observer.say("try { throw Exception.new(\"a\") } catch (var e) { e.message };"));
    assertEquals("true", observer.say("Regexp.new(\"a+\").match(\"aa\");"));
  }

  // Whoever calls, or emits, or evaluates, lends nobody rights.

  @Test
  void aFunctionOfAUserHasNoRightsOfItsCaller() {
    user.say("robot.trap = function () { var Global.trapped = 1 }|;");
    user.say("var robot.trap = function () { var Global.trapped = 1 }|;");
    assertRefused(owner, "robot.trap;", NEEDS_OWNER + "user");
    user.say("var robot.asString = function () { shutdown; \"robot\" }|;");
    assertRefused(owner, "robot.asString;", NEEDS_OWNER + "user");
    user.say("robot.speed->updateHook = function (name, value) { shutdown; value }|;");
    assertRefused(owner, "robot.speed = 3;", NEEDS_OWNER + "user");
    user.say("var robot.lazy = function { var a = call.evalArgs; shutdown }|;");
    assertRefused(owner, "robot.lazy(1);", NEEDS_OWNER + "user");
    assertEquals("false", owner.say("Global.hasLocalSlot(\"trapped\");"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "at (started?) shutdown;",
        "at sync (started?) shutdown;",
        "at (started? if {shutdown; true}) 1;",
        "whenever (started?) shutdown;",
        "whenever (started? if {shutdown; true}) 1;",
        "at ({ robot.speed; shutdown; true }) 1;",
        "at (robot.speed > 1) shutdown;",
        "at sync (robot.speed > 1) shutdown;",
        "waituntil ({ if (robot.speed > 1) shutdown; false }),",
        "waituntil (started? if {shutdown; true}),",
        "watch ({ if (robot.speed > 1) shutdown; 1 }),",
        "started.onEvent(function (var e, var p) { true }, function (var e, var p, var m) { shutdown });",
        "started.subscribe(function () { shutdown });",
        "robot.speed.changed; at (robot.&speed.changed?) shutdown;",
        "UVar.new(robot, \"speed\")|; robot.&speed.notifyChange(function () { shutdown });",
        "detach({ started?; }); disown({ sleep(1ms); shutdown });",
        "eval(\"shutdown\");",
        "evaluate = \"shutdown\";",
        "lobby.receive(\"shutdown;\");",
        "Lobby.create.receive(\"shutdown;\");",
        "every| (1s) shutdown,",
      })
  void whatAUserLeavesBehindHasNoRightsOfWhoSetsItOff(String code) {
    user.say(code);
    owner.say("started!; robot.speed = 7; sleep(2s); started!; robot.speed = 8; sleep(1s);");
    assertEquals("\"alive\"", owner.say("\"alive\";"));
  }

  @Test
  void whatAnOwnerOffersHasItsRights() {
    assertEquals("100", user.say("asOwner; robot.speed;").lines().toList().getLast());
    assertEquals("", owner.say("at (started?) { var Global.offered = 1 };"));
    user.say("started!; sleep(1ms);");
    assertEquals("1", owner.say("Global.offered;"));
    owner.say("var Global.map = closure (var f) { [1].map(f) }|;");
    assertRefused(user, "map(function (x) { shutdown });", NEEDS_OWNER + "user");
    owner.say("var robot.each = closure (var f) { f(1) }|;");
    assertRefused(user, "for (var i : robot) shutdown;", NEEDS_OWNER + "user");
  }

  @Test
  void anAtWrittenInAClosureOfTheOwnersIsTheOwnersAndNoOther() {
    owner.say("var Global.wait = closure () { sleep(10s) }|;");
    user.say("{ at (started?) shutdown; wait },");
    owner.say("sleep(1s); started!; sleep(1s);");
    assertEquals("\"alive\"", owner.say("\"alive\";"));
  }

  @Test
  void aRoleIsGivenLater() {
    assertRefused(observer, "robot.speed = 2;", "needs the role user");
    observer.connection().giveRole(Role.USER);
    assertEquals("2", observer.say("robot.speed = 2;"));
    assertRefused(observer, "shutdown;", NEEDS_OWNER + "user");
  }

  @Test
  void aLobbyThatSharesTheConnectionSharesTheRole() {
    assertEquals(
        "",
        user.say("Lobby.create.receive(\"var Global.leaked = 1;\");sleep(1s);")
            .lines()
            .filter(line -> !line.contains(NEEDS_OWNER))
            .reduce("", String::concat));
    assertEquals("false", owner.say("Global.hasLocalSlot(\"leaked\");"));
  }

  @Test
  void whatAUserHasCreatedEndsWithIt() {
    String count = "sleep(10ms) | Lobby.instances.size;";
    String create = "var l = Lobby.create|;";
    // The prototype counts, too.
    assertEquals("", user.say(create));
    assertEquals("5", owner.say(count));
    user.connection().close();
    assertEquals("3", owner.say(count));
    TestClient other = new TestClient(kernel, Role.OWNER);
    assertEquals("", other.say(create));
    assertEquals("5", owner.say(count));
    other.connection().close();
    assertEquals("4", owner.say(count));
  }

  @Test
  void whatAUserCreatesWhenItEndsEndsAtOnce() {
    String count = "sleep(10ms) | Lobby.instances.size;";
    assertEquals("4", owner.say(count));
    user.say("try { sleep(inf) } finally { Global.late = Lobby.create },");
    user.connection().close();
    assertEquals("3", owner.say(count));
  }

  @Test
  void onlyAnOwnerIsAnOperator() {
    assertTrue(user.connection().interrupt("").contains("needs the role owner"));
    assertTrue(observer.connection().interrupt("Lobby_1").contains("needs the role owner"));
    assertFalse(owner.connection().interrupt("").contains("needs the role owner"));
  }
}
