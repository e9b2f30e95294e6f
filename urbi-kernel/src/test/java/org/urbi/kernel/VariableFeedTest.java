package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.observe.Bytes;
import org.urbi.kernel.observe.VariableKind;
import org.urbi.kernel.observe.VariableListener;
import org.urbi.kernel.trust.Role;

/** Somebody is told of the variables of a running kernel, and gives them values. */
class VariableFeedTest {
  private static final String BALL =
      """
      var Global.ball = Object.new|;
      UVar.new(ball, "x")|; ball.x = 1|;
      """;

  private Kernel kernel;
  private TestClient program;

  /** Notes what it is told. */
  private static final class Looker implements VariableListener {
    private final Map<Integer, String> names = new ConcurrentHashMap<>();
    private final LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();
    private final LinkedBlockingQueue<Object> values = new LinkedBlockingQueue<>();
    private final Connection connection;
    private long time;

    Looker(Kernel kernel, Role role, boolean all, String... paths) {
      connection = new TestClient(kernel, role).connection();
      connection.feed(this, all, List.of(paths));
    }

    @Override
    public void appeared(int variable, String path, VariableKind kind) {
      names.put(variable, path);
      heard.add("+ " + path + " " + kind);
    }

    @Override
    public void gone(int variable) {
      heard.add("- " + names.remove(variable));
    }

    @Override
    public void value(int variable, long at, @Nullable Object value) {
      assertTrue(at >= time, "time does not go back");
      time = at;
      values.add(value == null ? "nil" : value);
      heard.add(names.get(variable) + " = " + (value instanceof Bytes ? "bytes" : value));
    }

    @Override
    public void logged(long at, String line) {
      heard.add("log " + line.strip());
    }

    @Override
    public void refused(String reason) {
      heard.add("refused " + reason);
    }

    void hears(String... lines) throws InterruptedException {
      for (String line : lines) {
        assertEquals(line, heard.take());
      }
    }

    void hearsNothing() {
      // Whatever came before this has been told.
      connection.values(List.of()).join();
      assertEquals(List.of(), List.copyOf(heard));
    }

    void follow(String path, boolean on) {
      names.forEach((number, name) -> {
        if (name.equals(path)) {
          connection.follow(number, on);
        }
      });
    }
  }

  @BeforeEach
  void start() {
    kernel = Kernel.builder().virtualTime(true).log(line -> {}).start();
    program = new TestClient(kernel, Role.OWNER);
  }

  @AfterEach
  void stop() {
    assertEquals("3", program.say("1 + 2;"));
    kernel.close();
  }

  @Test
  void aSlotWhoseNameIsEmptyIsNoObstacle() throws InterruptedException {
    program.say("var Global.'' = Object.new|;" + BALL + "'nothing';");
    Looker looker = new Looker(kernel, Role.OBSERVER, true);
    looker.hears("+ ball.x NUMBER");
  }

  @Test
  void tellsOnlyWhatIsFollowed() throws Exception {
    program.say(BALL);
    Looker looker = new Looker(kernel, Role.OBSERVER, false);
    looker.hears("+ ball.x NUMBER");
    program.say("ball.x = 2|;");
    looker.hearsNothing();
    looker.follow("ball.x", true);
    looker.hears("ball.x = 2.0");
    program.say("ball.x = 3|; ball.x = 3|;");
    looker.hears("ball.x = 3.0", "ball.x = 3.0");
    looker.follow("ball.x", false);
    program.say("ball.x = 4|;");
    looker.hearsNothing();
  }

  @Test
  void tellsWhenVariablesComeChangeTheirKindAndGo() throws Exception {
    Looker looker = new Looker(kernel, Role.OBSERVER, true);
    program.say("sleep(1s); var Global.o = Object.new|; UVar.new(o, \"v\")|;");
    looker.hearsNothing();
    program.say("o.v = [1, 2]|;");
    looker.hears("+ o.v NUMBERS", "o.v = [1.0, 2.0]");
    program.say("o.v = [];");
    looker.hears("o.v = []");
    program.say("o.v = [\"a\"]|;");
    looker.hears("- o.v", "+ o.v LIST", "o.v = [a]");
    program.say("o.v = nil|; o.v = true|; o.v = \"text\"|;");
    looker.hears("o.v = null", "- o.v", "+ o.v ANY", "o.v = true", "o.v = text");
    program.say("o.v = Binary.new(\"rgb 1 1\", \"abc\")|;");
    looker.hears("o.v = bytes");
    program.say("Global.removeLocalSlot(\"o\")|; var o = nil|; sleep(1s);");
    program.say("var o2 = Object.new|; UVar.new(o2, \"w\")|; o2.w = 1|;");
    looker.hears("+ o2.w NUMBER", "o2.w = 1.0");
    // One that is made before its object has a name is told again under that.
    program.say(
        "sleep(1s); function make() { var made = Object.new|; UVar.new(made, \"u\")|; made }|;");
    program.say("var made = List.new|; made << make|; made.front.u = 5|;");
    String first = looker.heard.take();
    assertTrue(first.matches("\\+ Object_0x\\w+.u NUMBER"), first);
    assertTrue(looker.heard.take().endsWith("u = 5.0"));
    program.say("sleep(1s); var named = made.front|; sleep(1s);");
    assertTrue(looker.heard.take().startsWith("- Object_0x"));
    looker.hears("+ named.u NUMBER", "named.u = 5.0");
    program.say(
        "function vanish() { named.removeLocalSlot(\"u\") }|; vanish|; sleep(1s); var any|; sleep(1s);");
    looker.hears("- named.u");
  }

  @Test
  void nestedAndEndlessValuesHaveAnEnd() throws Exception {
    program.say(BALL);
    Looker looker = new Looker(kernel, Role.OBSERVER, true);
    looker.hears("+ ball.x NUMBER", "ball.x = 1.0");
    looker.values.clear();
    program.say(
        "var l = []|; l << l|; ball.x = l|; ball.x = [1, Object.new, nil, function () {}]|;");
    looker.connection.values(List.of()).join();
    Object endless = looker.values.take();
    assertTrue(endless.toString().length() < 1000, "cut");
    assertEquals("[1.0, Object, null, Code]", looker.values.take().toString());
    program.say("var big = []|; for (var i: 30000) big << i|; ball.x = big|;");
    looker.connection.values(List.of()).join();
    List<?> last = (List<?>) looker.values.stream().reduce((a, b) -> b).orElseThrow();
    assertEquals(10_000, last.size());
  }

  @Test
  void anySlotCanBeToldEvenOneThatComesLater() throws Exception {
    Looker looker = new Looker(kernel, Role.OBSERVER, true, "robot.arm.x", "n", "a b", "a..b");
    looker.hears(
        "refused names of slots with periods between them expected, not a b",
        "refused names of slots with periods between them expected, not a..b");
    program.say("var Global.robot = Object.new|; var robot.arm = Object.new|;");
    looker.hearsNothing();
    program.say("var robot.arm.x = 1|;");
    looker.hears("+ robot.arm.x NUMBER", "robot.arm.x = 1.0");
    program.say("robot.arm.x = 2|; var robot.arm.y = 7|; robot.arm.x = 2|;");
    looker.hears("robot.arm.x = 2.0");
    // Another object takes its place, and the former one is of no interest.
    program.say("var old = robot.arm|; robot.arm = old.clone|; robot.arm.x = 3|; old.x = 4|;");
    looker.hears("robot.arm.x = 3.0");
    program.say("var n = [1]|; n << 2|;");
    looker.hears("+ n NUMBERS", "n = [1.0]", "n = [1.0, 2.0]");
    looker.hearsNothing();
  }

  @Test
  void valuesAreAskedForAndGiven() {
    program.say(BALL + "var Global.e = Event.new|; var Global.got = []|;");
    program.say("at (e?(var a, var b)) got << a + b; at (e?) got << \"e\";");
    Looker owner = new Looker(kernel, Role.OWNER, false);
    Connection by = owner.connection;
    assertEquals("", by.give("ball.x", 5.0).join());
    assertEquals("", by.give("e", List.of(3.0, 4.0)).join());
    assertEquals("7", program.say("waituntil (!got.empty); got.front;"));
    List<Object> values = by.values(List.of("ball.x", "nothing.here", "ball.1", "")).join();
    assertEquals(5.0, values.getFirst());
    assertNull(values.get(1));
    assertEquals("no such slot: ball.y", by.give("ball.y", 1.0).join());
    assertEquals("no such slot: x;shutdown", by.give("x;shutdown", 1.0).join());
    Map<String, Object> tree = new HashMap<>(Map.of("a", List.of(true, "é")));
    assertEquals("", by.give("ball.x", tree).join());
    assertEquals("true", program.say("ball.x[\"a\"] == [true, \"\\xc3\\xa9\"];"));
  }

  @Test
  void whatCannotBeDoneIsTold() {
    program.say(BALL + "ball.&x.notifyChange(function () { sleep(1h) })|;");
    Looker owner = new Looker(kernel, Role.OWNER, false);
    // The lobby is closed before its job gives the value, or after: nobody waits for ever.
    var given = owner.connection.give("ball.x", 2.0);
    owner.connection.close();
    try {
      given.join();
    } catch (CompletionException closed) {
      assertInstanceOf(CancellationException.class, closed.getCause());
    }
    program.say("const var Global.c = 1|;");
    Looker other = new Looker(kernel, Role.OWNER, false);
    assertTrue(other.connection.give("c", 2.0).join().contains("cannot modify const slot"));
  }

  @Test
  void rolesHoldForWhatIsGiven() {
    program.say(BALL + "var Global.e = Event.new|; var mine = 1|;");
    Looker observer = new Looker(kernel, Role.OBSERVER, false);
    assertTrue(observer.connection.give("ball.x", 2.0).join().contains("needs the role user"));
    assertTrue(observer.connection.give("e", List.of()).join().contains("needs the role user"));
    assertEquals("1", program.say("ball.x;"));
    Looker user = new Looker(kernel, Role.USER, false);
    assertEquals("", user.connection.give("ball.x", 2.0).join());
    assertTrue(user.connection.give("mine", 2.0).join().contains("needs the role owner"));
    assertEquals("2", program.say("ball.x;"));
  }

  @Test
  void theLogIsTold() throws Exception {
    Looker looker = new Looker(kernel, Role.OBSERVER, false);
    looker.hearsNothing();
    program.say("Logger.log(\"hello\")|;");
    assertTrue(looker.heard.take().contains("hello"));
  }

  @Test
  void whoHasLeftIsToldNothing() throws Exception {
    program.say(BALL);
    Looker looker = new Looker(kernel, Role.OBSERVER, true);
    looker.hears("+ ball.x NUMBER", "ball.x = 1.0");
    looker.connection.close();
    assertThrows(
        CancellationException.class, () -> looker.connection.values(List.of("ball.x")).join());
    program.say("ball.x = 2|; Logger.log(\"x\")|;");
    assertEquals(List.of(), List.copyOf(looker.heard));
  }

  @Test
  void replayDoesWhatWasDone(@TempDir Path folder) {
    Path recording = folder.resolve("run");
    try (Kernel recorded =
        Kernel.builder().virtualTime(true).record(recording).log(line -> {}).start()) {
      TestClient client = new TestClient(recorded, Role.OWNER);
      client.say(BALL);
      Looker looker = new Looker(recorded, Role.OWNER, true, "ball.x");
      assertEquals("", looker.connection.give("ball.x", Map.of("k", List.of(1.0))).join());
      looker.follow("ball.x", false);
      looker.connection.values(List.of("ball.x")).join();
      assertEquals("[\"k\" => [1]]", client.say("ball.x;"));
    }
    ReplayedRun.check(recording);
  }
}
