package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.trust.Role;

/** What a lobby has more than its budget of is an exception to it, and to nobody else. */
class BudgetTest {
  private static final String EXHAUSTED = "the budget of this lobby is exhausted: ";

  private final Kernel kernel = Kernel.builder().log(line -> {}).virtualTime(true).start();

  @AfterEach
  void close() {
    kernel.close();
  }

  private TestClient owner() {
    return new TestClient(kernel, Role.OWNER);
  }

  private static void assertExhausted(String what, String answer) {
    assertTrue(answer.contains(EXHAUSTED + what), answer);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "for& (200) sleep(1h);",
        "for (200) detach({ sleep(1h) });",
        "function h() { h() & h() }; h();",
        "every (1ms) detach({ sleep(1h) }), sleep(1s);",
      })
  void jobs(String program) {
    TestClient bomb = owner();
    TestClient judge = owner();
    bomb.say("lobby.setBudget(\"jobs\", 100);");
    assertExhausted(
        "100 jobs", bomb.say("try {" + program + "} catch (var x) { echo(x.message) };"));
    assertEquals("2", judge.say("1+1;"));
    assertEquals("true", bomb.say("lobby.budgetUsed(\"jobs\") <= 100;"));
    bomb.connection().close();
    assertEquals("2", judge.say("1+1;"));
  }

  @Test
  void whatHasEndedIsCountedNoMore() {
    TestClient one = owner();
    one.say("lobby.setBudget(\"jobs\", 100);");
    assertEquals("1", one.say("lobby.budgetUsed(\"jobs\");"));
    for (int i = 0; i < 5; i++) {
      assertEquals("done", one.say("for& (90) sleep(1s); lobby.send(\"done\");"));
    }
    assertEquals("1", one.say("lobby.budgetUsed(\"jobs\");"));
    assertEquals("inf", one.say("lobby.budget(\"timers\");"));
    assertEquals("100", one.say("lobby.budget(\"jobs\");"));
  }

  @Test
  void aLobbyThatCodeMakesSharesTheBudgetOfItsMaker() {
    TestClient one = owner();
    one.say("lobby.setBudget(\"jobs\", 10); var Global.made = Lobby.create|;");
    String answer = one.say("made.receive(\"for& (20) sleep(1h);\"); sleep(1s);");
    assertExhausted("10 jobs", answer);
  }

  @Test
  void timers() {
    TestClient one = owner();
    one.say("lobby.setBudget(\"timers\", 10);");
    assertExhausted("10 timers", one.say("for& (11) { timeout (1s) sleep(2s) };"));
    assertEquals("0", one.say("lobby.budgetUsed(\"timers\");"));
    assertEquals("", one.say("for& (10) { timeout (1s) sleep(2s) };"));
    assertEquals("0", one.say("lobby.budgetUsed(\"timers\");"));
  }

  @Test
  void processes() {
    TestClient one = owner();
    one.say("lobby.setBudget(\"processes\", 2);");
    one.say("function start() { var p = Process.new(\"sleep\", [\"1000\"]) | p.run | p }|;");
    one.say("var one = start|; var two = start|;");
    assertExhausted("2 processes", one.say("start;"));
    assertExhausted("2 processes", one.say("System.system(\"true\");"));
    one.say("one.kill | one.join;");
    assertEquals("1", one.say("lobby.budgetUsed(\"processes\");"));
    String missing = one.say("Process.new(\"/nowhere\", []).run;");
    assertTrue(missing.contains("!!!") && !missing.contains(EXHAUSTED), missing);
    assertEquals("", one.say("start|;"));
    assertExhausted("2 processes", one.say("start;"));
  }

  @Test
  void input() {
    TestClient one = owner();
    one.say("lobby.setBudget(\"input\", 200);");
    String answer = one.say("\"" + "x".repeat(300) + "\";");
    assertTrue(answer.contains("statement longer than 200 characters"), answer);
    assertEquals("2", one.say("1+1;"));
  }

  /** Whatever code has that sends something to its client. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "echo(2);",
        "lobby.send(\"2\");",
        "lobby.write(\"2\");",
        "cout << 2;",
        "clog << 2;",
        "lobby << 2;",
        "Channel.Filter << 2;",
        "2;",
        "2.print;",
        "2.inspect;",
        "2.dump(0);",
        "warn(\"2\");",
        "Regexp.new(\"2\").matchs;",
        "System.ps;",
        "System.jobs[0].dumpState;",
        "var f = function() { System.backtrace }|; f;",
        "Kernel1.ping;",
        "lobby.thanks;",
        "t.begin: nil|; echo(2);",
      })
  void output(String program) throws InterruptedException {
    AtomicLong unread = new AtomicLong();
    LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();
    Connection connection =
        kernel.connect(
            new Client() {
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

              @Override
              public String budget() {
                return "output=1k";
              }
            },
            false);
    connection.send("var t = Tag.new(\"t\")|; echo(1);\n");
    assertTrue(heard.take().contains("*** 1"));
    unread.set(1025);
    connection.send(program + "\n");
    String answer = heard.take();
    assertExhausted("1024 bytes of unread output", answer);
    assertFalse(answer.contains("begin"), answer);
    unread.set(1024);
    connection.send("echo(3);\n");
    assertTrue(heard.take().contains("*** 3"));
  }

  /** What is made in one piece is refused before it is there: nobody could be ended in between. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "Matrix.new(1024, 1024)",
        "Matrix.new(v)",
        "m[0, 0] = 1",
        "m + m",
        "m * 2",
        "m.transpose",
        "m.row(0)",
        "n.column(0)",
        "n * Vector.new([1])",
        "v[0] = 1",
        "v + v",
        "v / 2",
        "Vector.new(l)",
        "b + b",
        "s + s",
        "s * 2",
        "\"aaa\".replace(\"a\", s)",
        "[s, s].join",
        "[].join(\", \", s, s)",
        "l + [1]",
        "l += l",
      })
  void memoryOfWhatIsMadeAtOnce(String program) {
    TestClient one = owner();
    assertEquals(
        "",
        one.say(
            "var l = [0] * 1048577|; var v = Vector.new(l)|; var m = Matrix.new(v)|;"
                + " var n = m.transpose|; var s = \"a\" * 4194305|; var b = Binary.new(\"\", s)|;"
                + " lobby.setBudget(\"memory\", 4194304)|;"));
    String answer = one.say("try { " + program + " | 0 } catch (var x) { echo(x.message) };");
    assertTrue(answer.startsWith("*** "), answer);
    assertExhausted("4194304 bytes", answer);
  }

  @Test
  void clonesOfMatricesTakeNoMemoryUntilTheyAreChanged() {
    TestClient one = owner();
    one.say("var m = Matrix.new(1024, 1024)|;");
    one.say("lobby.setBudget(\"memory\", 4194304)|;");
    assertEquals("0", one.say("var n = m.clone|; n[3, 3];"));
    one.say("lobby.setBudget(\"memory\", inf)|; n[3, 3] = 1|;");
    assertEquals("[0, 1]", one.say("[m[3, 3], n[3, 3]];"));
    assertEquals(
        "[1, 2]", one.say("var v = Vector.new(1)|; var w = v.clone|; w[0] = 2|; [v[0], w[0]];"));
  }

  @Test
  void time() {
    try (Kernel real = Kernel.builder().log(line -> {}).start()) {
      TestClient busy = new TestClient(real, Role.OWNER);
      TestClient judge = new TestClient(real, Role.OWNER);
      assertEquals("0", judge.say("var Global.beats = 0;"));
      judge.say("every (1ms) Global.beats++,");
      busy.say("lobby.setBudget(\"time\", 20);");
      busy.connection().send("loop { for| (1000) {} },\n");
      String line = busy.next();
      assertExhausted("20 % of the kernel's time", line);
      assertEquals("true", judge.say("var seen = beats|; sleep(100ms); beats > seen;"));
      assertEquals("2", busy.say("1+1;"));
    }
  }

  /** Without a general limit of holding. */
  @Test
  void holding() {
    try (Kernel real = Kernel.builder().log(line -> {}).start()) {
      TestClient client = new TestClient(real, Role.OWNER);
      client.say("lobby.setBudget(\"hold\", 20);");
      assertTrue(client.say("while| (true) {};").contains("has held the kernel for too long"));
      assertEquals("2", client.say("1+1;"));
    }
  }

  @Test
  void depth() {
    TestClient client = owner();
    client.say("function deep(n) { if (n == 0) 0 else deep(n - 1) };");
    client.say("lobby.setBudget(\"depth\", 100);");
    assertEquals("0", client.say("deep(90);"));
    assertTrue(client.say("deep(110);").contains("stack space exhausted"));
    TestClient other = owner();
    other.say("function deep(n) { if (n == 0) 0 else deep(n - 1) };");
    assertEquals("0", other.say("deep(500);"));
  }

  @Test
  void onlyAnOwnerSetsBudgets() {
    TestClient user = new TestClient(kernel, Role.USER);
    assertTrue(user.say("lobby.setBudget(\"jobs\", inf);").contains("needs the role owner"));
    assertTrue(owner().say("lobby.budget(\"gold\");").contains("no such part of a budget: gold"));
    assertTrue(owner().say("lobby.setBudget(\"jobs\", -1);").contains("limit of 0 or more"));
  }

  @ParameterizedTest
  @CsvSource({
    "jobs=7,JOBS,7",
    "' input = 2k',INPUT,2048",
    "'jobs=1,output=3M',OUTPUT,3145728",
    "time=50%,TIME,50",
    "'hold=5,depth=1000',HOLD,5"
  })
  void optionsSayLimits(String text, Resource what, long limit) {
    Budget budget = new Budget();
    budget.setLimits(text);
    assertEquals(limit, budget.limit(what));
    assertEquals(Budget.UNLIMITED, budget.limit(Resource.PROCESSES));
  }

  @ParameterizedTest
  @ValueSource(strings = {"jobs", "jobs=", "jobs=-1", "gold=1", "jobs=1 output=2", "jobs=1m", ","})
  void optionsThatMakeNoSense(String text) {
    assertThrows(IllegalArgumentException.class, () -> new Budget().setLimits(text));
  }

  @Test
  void theMemoryLimitsJobs() {
    Budget budget = new Budget();
    budget.setLimits(Budget.fitting(400 << 20, "timers=3"));
    assertEquals(51_200, budget.limit(Resource.JOBS));
    assertEquals(3, budget.limit(Resource.TIMERS));
    budget.setLimits(Budget.fitting(400 << 20, "jobs=3"));
    assertEquals(3, budget.limit(Resource.JOBS));
  }

  /** A device has no end: what is read of it does not fill the memory. */
  @Test
  void memoryOfWhatIsReadOfAFile(@TempDir Path folder) throws IOException {
    TestClient one = owner();
    Path file = folder.resolve("large");
    Files.write(file, new byte[2_000_000]);
    String read = "File.new(\"" + file + "\").content.data.size;";
    assertEquals("2000000", one.say(read));
    one.say("lobby.setBudget(\"memory\", 1000000)|;");
    assertExhausted("1000000 bytes", one.say(read));
    assertTrue(one.say("File.new(\"/dev/zero\").content;").contains("file too large"));
  }
}
