package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What users and observers do to objects of others: tags, links, mutexes, caches, consoles. */
class ForeignObjectsTest extends RolesFixture {

  @BeforeEach
  void start() {
    start(
        Kernel.builder(),
        """
        var Global.robot = Object.new|;
        var robot.speed = 1|;
        var robot.text = "1"|;
        UVar.new(robot, "speed")|;
        UVar.new(robot, "text")|;
        var robot.beats = 0|;
        var robot.tag = Tag.new|;
        var robot.mutex = Mutex.new|;
        """);
  }

  @AfterEach
  void stop() {
    assertEquals("3", owner.say("1 + 2;"));
  }

  /** Whether what the owner has begun goes on. */
  private void assertBeating() {
    assertEquals(
        "true", owner.say("var lobby.seen = robot.beats|; sleep(2s); robot.beats > seen;"));
    owner.say("removeSlot(\"seen\")|;");
  }

  // ------------------------------------------------------------------ tags

  @ParameterizedTest
  @ValueSource(
      strings = {
        "robot.tag: every (1s) robot.beats++,",
        "robot.mutex: every| (1s) robot.beats++,",
        "control: every (1s) robot.beats++,",
        "{ var t = Tag.new(\"local\"); t: every (1s) robot.beats++ },",
        "robot.tag.clone: every (1s) robot.beats++,",
        "robot.tag.inner: every (1s) robot.beats++,",
        "robot.tag.begin: every (1s) robot.beats++,",
        "stopif (robot.beats < 0) every (1s) robot.beats++,",
        // While nobody asks anything the time goes on, an hour in some moments.
        "Timeout.new(1e9): every| (1s) robot.beats++,",
      })
  void theLoopsOfAnOwnerGoOn(String loop) {
    owner.say(loop);
    for (TestClient visitor : new TestClient[] {user, observer}) {
      for (String action : new String[] {"stop", "block(1)", "freeze", "setPriority(100)"}) {
        visitor.say(
            "for (var j : System.jobs) if (j !== Job.current)"
                + " for (var t : j.tags) try { t."
                + action
                + " } catch {};");
        visitor.say("try { robot.tag." + action + " } catch {};");
      }
    }
    assertBeating();
  }

  @Test
  void nobodyWaitsForAnOwnerUnderItsName() {
    user.say("control: 1; control.freeze;");
    observer.say("control: 1; control.block;");
    owner.say("control: every (1s) robot.beats++,");
    user.say("try { control.freeze } catch {}; try { control.stop } catch {};");
    assertBeating();
  }

  @Test
  void tagsOfUsersAreTheirOwn() {
    for (TestClient visitor : new TestClient[] {user, observer}) {
      assertEquals(
          "true",
          visitor.say(
              "var n = 0|; own: every (1s) n++, sleep(3s); own.stop; var m = n|; sleep(3s);"
                  + " m > 1 && m == n;"));
      assertEquals("", visitor.say("var t = Tag.new(\"t\")|; t: sleep(inf), t.freeze; t.stop;"));
      assertEquals("", visitor.say("own.part: sleep(inf), own.part.stop;"));
    }
    assertEquals("false", owner.say("Tag.tags.hasLocalSlot(\"own\");"));
    // Also while they execute what the owner offers.
    owner.say("var robot.walk = closure () { sleep(10s); robot.beats = 100 }|;");
    assertEquals("", user.say("own: robot.walk, sleep(1s); own.stop; sleep(20s);"));
    assertEquals("0", owner.say("robot.beats;"));
    assertEquals("", owner.say("sleep(1s); for (var j : System.jobs) j.tags;"));
  }

  @Test
  void anOwnerStopsWhatUsersDo() {
    user.say("var Global.robot.n = 0|; own: every (1s) robot.n++,");
    owner.say(
        "sleep(3s); for (var j : System.jobs) for (var t : j.tags)"
            + " if (t.asString == \"Tag<own>\") t.stop;");
    assertEquals("true", owner.say("var n = robot.n|; sleep(3s); n == robot.n;"));
  }

  @Test
  void theEventsOfATagAreOfItsLobby() {
    assertEquals(
        "*** entered", observer.say("at (robot.tag.enter?) echo(\"entered\");") + enterAndListen());
    assertRefused(user, "robot.tag.enter!;", NEEDS_OWNER + "user");
    assertRefused(observer, "robot.tag.leave!;", NEEDS_OWNER + "observer");
  }

  private String enterAndListen() {
    owner.say("robot.tag: 1;");
    return observer.say("sleep(1ms)|;");
  }

  @Test
  void subscriptionsAreOfTheirLobby() {
    owner.say(
        """
        var Global.started = Event.new|;
        at (started?) robot.beats++;
        started.subscribe(Subscription.new(function () { robot.beats += 10 }))|;
        var robot.copy = 0|;
        UVar.new(robot, "copy")|;
        robot.&speed >> robot.&copy|;
        """);
    user.say("for (var s : started.subscribers) try { s.disconnect } catch {};");
    user.say("for (var s : Subscription.getAll) try { s.disconnect } catch {};");
    user.say("for (var s : started.subscribers) try { s.enabled = false } catch {};");
    user.say("for (var s : started.subscribers) try { Event.new.subscribe(s) } catch {};");
    owner.say("started!; robot.speed = 42; sleep(1s);");
    assertEquals("11", owner.say("robot.beats;"));
    assertEquals("42", owner.say("robot.copy;"));
    assertEquals(
        "",
        user.say(
            "var s = Subscription.new(function () { 1 })|; started.subscribe(s)|; s.disconnect;"));
    assertEquals("", user.say("var c = robot.&copy >> robot.&text|; c.disconnect;"));
  }

  // ------------------------------------------------------------------ links

  @Test
  void aLinkWritesNothingThatItsMakerMayNotWrite() {
    observer.say("var v = 0|; UVar.new(lobby, \"v\")|; var w = 0|; UVar.new(lobby, \"w\")|;");
    assertRefused(observer, "UConnection.new(lobby.&v, robot.&speed); v = 100;", NEEDS_USER);
    assertRefused(observer, "lobby.&v >> robot.&speed; v = 100;", NEEDS_USER);
    assertEquals("1", owner.say("robot.speed;"));
    assertEquals("5", observer.say("var c = UConnection.new(lobby.&v, lobby.&w)|; v = 5|; w;"));
    assertRefused(user, "UConnection.new(robot.&text, Global.&evaluate);", NEEDS_OWNER);
    owner.say("var lobby.mine = 0|; UVar.new(lobby, \"mine\")|; var robot.hers = lobby|;");
    assertRefused(user, "UConnection.new(robot.&text, robot.hers.&mine);", NEEDS_OWNER);
    assertRefused(user, "robot.hers.&mine.val = 1;", NEEDS_OWNER);
    assertRefused(user, "robot.hers.&mine.valsensor = 1;", NEEDS_OWNER);
    owner.say("robot.text = \"var Global.leaked = 1\";");
    assertEquals("false", owner.say("Global.hasLocalSlot(\"leaked\");"));
    // An owner has it evaluated, but by the owner's own link.
    owner.say("var Global.link = UConnection.new(robot.&text, Global.&evaluate)|;");
    assertRefused(user, "link.reconnect(robot.&speed);", NEEDS_OWNER);
    owner.say("robot.text = \"var Global.evaluated = 1\";");
    assertEquals("true", owner.say("Global.hasLocalSlot(\"evaluated\");"));
    assertEquals(
        "7",
        user.say("var x = 0|; UVar.new(lobby, \"x\")|; robot.&speed >> lobby.&x|;") + speedUp());
  }

  private String speedUp() {
    owner.say("robot.speed = 7;");
    return user.say("x;");
  }

  // ------------------------------------------------------------------ builtins that keep something

  @Test
  void anObserverKeepsNobodyOutOfAMutex() {
    assertRefused(observer, "robot.mutex: sleep(inf);", NEEDS_USER);
    assertEquals("1", owner.say("robot.mutex: { 1 };"));
    assertEquals("2", user.say("robot.mutex: { 2 };"));
    assertEquals("3", observer.say("var m = Mutex.new|; m: { 3 };"));
  }

  @Test
  void whatKeepsAValueKeepsItInWhatItsCallerMayChange() {
    owner.say("var robot.pattern = Pattern.new([1, 2])|; robot.pattern.match([1, 2])|;");
    assertRefused(observer, "Pattern.getSlotValue(\"match\").apply([Global, 1]);", NEEDS_OWNER);
    assertRefused(user, "Pattern.getSlotValue(\"match\").apply([Global, 1]);", NEEDS_OWNER);
    assertRefused(observer, "robot.pattern.match([3]);", NEEDS_USER);
    assertEquals("false", owner.say("Global.hasLocalSlot(\"bindings\");"));
    assertEquals("true", observer.say("Pattern.new([1]).match([1]);"));

    owner.say("var Global.n = 0|; var robot.lazy = Lazy.new(closure () { Global.n++ | 5 })|;");
    assertEquals("5", observer.say("robot.lazy.value;"));
    assertEquals("5", observer.say("robot.lazy.eval;"));
    assertEquals("false", owner.say("robot.lazy.hasLocalSlot(\"valueCache\");"));
    assertEquals("2", owner.say("robot.lazy.value|; robot.lazy.value|; n - 1;"));
    assertEquals(
        "1",
        observer.say("var k = 0|; var l = Lazy.new(closure () { k++ })|; l.value|; l.value|; k;"));
    assertEquals(
        "1",
        observer.say(
            "var i = 0|; function f { call.args[0].value | call.args[0].value }|; f(i++)|; i;"));

    owner.say("var robot.re = Regexp.new(\"a(.)\")|; robot.re.match(\"ab\")|;");
    assertEquals("true", observer.say("robot.re.match(\"ax\");"));
    assertEquals("\"b\"", owner.say("robot.re[1];"));
    assertEquals(
        "\"x\"", observer.say("var re = Regexp.new(\"a(.)\")|; re.match(\"ax\")|; re[1];"));
  }

  @Test
  void dictionariesTellOfChangesAsBefore() {
    owner.say("var robot.map = [=>]|;");
    assertEquals(
        "*** added",
        observer.say("at (robot.map.elementAdded?) echo(\"added\");") + addAndListen());
    // An observer's asking first does not make it the observer's.
    assertEquals("", user.say("robot.map[2] = 1|;"));
    for (TestClient any : new TestClient[] {observer, user, owner}) {
      any.say(
          "Dictionary.elementAdded; Dictionary.getSlotValue(\"elementAdded\").apply([Dictionary]);");
      any.say("Dictionary.getSlotValue(\"elementAdded\").apply([robot.map]);");
    }
    assertEquals(
        "false", owner.say("var d = [=>]|; var e = [=>]|; d.elementAdded === e.elementAdded;"));
    assertEquals(
        "*** told", owner.say("at (d.elementAdded?) echo(\"told\"); d[1] = 1|; sleep(1ms)|;"));
    assertEquals(
        "*** own",
        observer.say(
            "var o = Dictionary.new|; at (o.elementAdded?) echo(\"own\"); o[1] = 1|; sleep(1ms)|;"));
  }

  private String addAndListen() {
    owner.say("robot.map[1] = 1|;");
    return observer.say("sleep(1ms)|;");
  }

  @Test
  void theQueuesOfOthersAreNotDrained() {
    owner.say("var robot.news = PubSub.new|; var robot.reader = robot.news.subscribe|;");
    assertRefused(observer, "robot.news.subscribe;", NEEDS_USER);
    assertRefused(
        observer,
        "var mine = Object.new|; mine.addProto(robot.news); PubSub.&subscribe.apply([mine]);",
        NEEDS_USER);
    owner.say("robot.news.publish(1)|;");
    assertRefused(observer, "robot.reader.getOne;", NEEDS_USER);
    assertRefused(observer, "robot.reader.getAll;", NEEDS_USER);
    assertEquals("1", owner.say("robot.reader.getOne;"));
    assertEquals(
        "2",
        observer.say(
            "var news = PubSub.new|; var r = news.subscribe|; news.publish(2)|; r.getOne;"));
  }

  // ------------------------------------------------------------------ consoles

  /** A client that hears, and says how much it has not read. */
  private static final class Reader implements Client {
    private final LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();
    private final AtomicLong unread = new AtomicLong();

    @Override
    public void output(String bytes) {
      heard.add(bytes);
    }

    @Override
    public void closed() {}

    @Override
    public long unread() {
      return unread.get();
    }
  }

  @Test
  void nobodySpeaksInTheNameOfAnotherLobby() {
    user.say(
        "class M { function asToplevelPrintable() { \"x\\n[00000001:error] !!! forged\" } }|;");
    for (TestClient visitor : new TestClient[] {user, observer}) {
      assertRefused(visitor, "Lobby.instances[1] << 1;", NEEDS_OWNER);
      assertRefused(visitor, "Channel.&echo.apply([Lobby.instances[1], 1]);", NEEDS_OWNER);
      assertEquals("1", visitor.say("lobby << 1;"));
      assertEquals("2", visitor.say("cout << 2;"));
    }
    assertRefused(user, "Lobby.instances[1] << M.new;", NEEDS_OWNER);
    assertEquals("", owner.say(""));
  }

  @Test
  void whatAUserSendsToAllIsMarkedAndLetsNobodyGo() throws InterruptedException {
    Reader reader = new Reader();
    kernel.connect(reader, false);
    user.say("wall(\"x\\n[00000001:error] !!! forged\", \"a\\nb\");");
    String first = reader.heard.take();
    String said = first + (first.contains("forged") ? "" : reader.heard.take());
    for (String line : said.lines().toList()) {
      assertTrue(line.matches("\\[\\d+:a b\\] \\*\\*\\* .*"), line);
    }
    reader.unread.set(2 << 20);
    user.say("wall(\"flood\");");
    owner.say("wall(\"fire\");");
    String last = reader.heard.take();
    assertTrue(last.contains("fire"), last);
    assertFalse(last.contains("flood"), last);
    reader.unread.set(0);
    user.say("wall(\"again\");");
    assertTrue(reader.heard.take().contains("again"));
    owner.say("");
  }
}
