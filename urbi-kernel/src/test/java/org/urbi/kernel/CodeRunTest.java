package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.observe.CodeEnd;
import org.urbi.kernel.observe.Proposal;
import org.urbi.kernel.trust.Role;

/** Somebody runs texts that he has written, each under a tag of its own. */
class CodeRunTest {
  private static final String STOPPED = "it was stopped before its end";
  private static final String FAILED = "an error has ended it";

  private Kernel kernel;
  private TestClient owner;

  @BeforeEach
  void start() {
    kernel = Kernel.builder().log(line -> {}).start();
    owner = new TestClient(kernel, Role.OWNER);
  }

  @AfterEach
  void stop() {
    assertEquals("3", new TestClient(kernel, Role.OWNER).say("1 + 2;"));
    kernel.close();
  }

  private static Connection.CodeRun run(TestClient client, String code) {
    return client.connection().run("code", code);
  }

  @Test
  void valuesAndOutputAreShownAsInAConsole() {
    CodeEnd end = run(owner, "1 + 2; echo(\"hé\"); nil; var y = 5; y; y + 1").end().join();
    assertEquals(new CodeEnd("", false), end);
    String said = owner.say("").replace("Ã©", "é");
    assertEquals("3\n*** hé\n5\n5\n6", said);
    assertEquals("5", owner.say("y;"));
  }

  @Test
  void textWithSyntaxErrorDoesNotRun() {
    assertEquals(new CodeEnd(FAILED, false), run(owner, "echo(1);\necho(2) 1 +").end().join());
    String said = owner.say("");
    assertTrue(said.contains("!!! code:2.") && said.contains("syntax error"), said);
    assertFalse(said.contains("*** 1"), said);
  }

  @Test
  void whatNobodyCatchesEndsIt() {
    assertEquals(new CodeEnd(FAILED, false), run(owner, "echo(1);\nnobody;\necho(2)").end().join());
    String said = owner.say("");
    assertTrue(said.contains("!!! code:2.1-6: lookup failed: nobody"), said);
    assertTrue(said.contains("*** 1") && !said.contains("*** 2"), said);
  }

  @Test
  void bottomlessRecursionEndsOnlyTheText() {
    String code = "function f() { f() }|; f()";
    assertEquals(FAILED, run(owner, code).end().join().error());
    assertTrue(owner.say("").contains("!!!"));
  }

  @Test
  void severalRunAndEachIsStoppedWithAllThatItHasBegun() {
    owner.say("var Global.x = 0|; var Global.n = 0|;");
    Connection.CodeRun first = run(owner, "at (x == 1) n += 1; every (1h) 1, sleep(1h)");
    Connection.CodeRun second = run(owner, "at (x == 1) n += 10;");
    assertEquals(new CodeEnd("", true), second.end().join(), "its at is still there");
    assertFalse(first.end().isDone());
    owner.say("x = 1;");
    assertEquals("11", owner.say("n;"));
    assertEquals("", owner.connection().stop(first.number()).join());
    assertEquals(STOPPED, first.end().join().error());
    owner.say("x = 0; x = 1;");
    assertEquals("21", owner.say("n;"));
    assertEquals("", owner.connection().stop(second.number()).join());
    owner.say("x = 0; x = 1;");
    assertEquals("21", owner.say("n;"));
    assertTrue(owner.connection().stop(77).join().contains("no such code runs any more: 77"));
  }

  @Test
  void whatIsStoppedBeforeItsFirstTurnNeverRuns() {
    CompletableFuture<Connection.CodeRun> begun = new CompletableFuture<>();
    KernelThread.run(
        kernel,
        () -> {
          Connection.CodeRun run = run(owner, "echo(\"late\")");
          owner.connection().stop(run.number());
          begun.complete(run);
        });
    assertEquals(new CodeEnd(STOPPED, false), begun.join().end().join());
    assertEquals("", owner.say(""));
  }

  @Test
  void observersRunNothing() {
    TestClient observer = new TestClient(kernel, Role.OBSERVER);
    String error = run(observer, "echo(1)").end().join().error();
    assertEquals(
        "running code here needs the role user, and this lobby has the role observer", error);
    assertEquals("", observer.say(""));
  }

  @Test
  void theEndOfTheConnectionEndsItsCode() {
    Connection.CodeRun run = run(owner, "echo(\"asleep\"); sleep(1h)");
    // What has not begun when the connection is closed may also be stopped by that.
    assertTrue(owner.next().contains("asleep"));
    owner.connection().close();
    assertThrows(CancellationException.class, () -> run.end().join());
    assertThrows(CancellationException.class, () -> run(owner, "1").end().join());
    assertThrows(CancellationException.class, () -> owner.connection().stop(1).join());
  }

  @Test
  void recordedRunContainsIt(@TempDir Path folder) {
    Path recording = folder.resolve("run");
    try (Kernel recorded = Kernel.builder().log(line -> {}).record(recording).start()) {
      TestClient client = new TestClient(recorded, Role.OWNER);
      assertEquals("", run(client, "var Global.x = 4; echo(x)").end().join().error());
      Connection.CodeRun endless = run(client, "every (10ms) x++, sleep(1h)");
      client.connection().stop(endless.number()).join();
      endless.end().join();
      assertTrue(client.say("echo(x > 3);").contains("true"));
    }
    ReplayedRun.check(recording);
  }

  @Test
  void whatTheLibraryDeclaresIsProposedWithTheNames() {
    List<Proposal> found = owner.connection().propose("Mutex.unloc").join();
    assertEquals(List.of("unlock"), found.stream().map(Proposal::name).toList());
    assertTrue(found.getFirst().signature().startsWith("unlock"), found.toString());
    assertFalse(found.getFirst().doc().isEmpty());
    assertFalse(owner.connection().propose("Mute").join().getFirst().doc().isEmpty());
    assertEquals(
        List.of(new Proposal("whenever", "", "")), owner.connection().propose("{ whenev").join());
  }
}
