package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.observe.EventRow;
import org.urbi.kernel.observe.ReactionRow;
import org.urbi.kernel.trust.Role;

/** Somebody looks at the reactions and events of a running kernel, and emits events. */
class ReactionViewTest {
  private Kernel kernel;
  private TestClient program;
  private Viewer owner;

  @BeforeEach
  void start() {
    kernel = Kernel.builder().log(line -> {}).start();
    program = new TestClient(kernel, Role.OWNER);
    owner = new Viewer(kernel, Role.OWNER);
  }

  @AfterEach
  void stop() {
    assertEquals("3", program.say("1 + 2;"));
    kernel.close();
  }

  @Test
  void tellsWhatReactsHowOftenAndToWhat() {
    program.say(
        """
        var Global.x = 0|; var Global.e = Event.new|; var Global.seen = 0|;
        at (x > 1) seen++;
        at (e?(var n)) seen += n;
        var w = watch(x * 2)|;
        named: every (1h) { seen++ },
        whenever (x == 5) sleep(1h),
        """);
    program.say("x = 2; x = 0; x = 3; e!(4); e!(5);");
    ReactionRow at = owner.reaction("at (x > 1)");
    assertEquals(2, at.times());
    assertEquals(List.of("x"), at.read());
    assertTrue(at.last() >= 0, at.toString());
    ReactionRow onEvent = owner.reaction("at (e?(var n))");
    assertEquals(2, onEvent.times());
    assertEquals(owner.event("e").number(), onEvent.event());
    // Also a new slot of the lobby has it evaluated: it might be called x.
    assertTrue(owner.reaction("watch(x * 2)").times() >= 4, owner.reactions.toString());
    ReactionRow every = owner.reaction("every (1h)");
    assertEquals(1, every.times());
    assertEquals(2, every.tags().size());
    assertEquals(0, owner.reaction("whenever (x == 5)").times());
    EventRow event = owner.event("e");
    assertEquals(List.of(1, 2L), List.of(event.listeners(), event.times()));
    assertNull(owner.lookFor(null).last.reactions(), "nobody wants to see them");
  }

  @Test
  void stoppedReactionsAreGone() {
    program.say("var Global.x = 0|; mine: at (x == 1) x; mine: every (1h) x,");
    owner.reaction("at (x == 1)");
    program.say("mine.stop;");
    assertTrue(owner.lookFor("").reactions.isEmpty(), () -> owner.reactions.toString());
  }

  @Test
  void onlyChangesAreTold() {
    program.say("var Global.x = 0|; at (x == 1) x; var Global.robot = Object.clone|;");
    program.say("var Global.robot.touched = Event.new|;");
    assertEquals("robot.touched", owner.event("robot.touched").name());
    owner.lookFor("");
    assertEquals(List.of(), owner.last.reactions().reactions());
    assertEquals(List.of(), owner.last.reactions().events());
    program.say("x = 1;");
    assertEquals(1, owner.lookFor("").last.reactions().reactions().size());
    assertFalse(owner.last.reactions().anew(), "what was told before is still true");
    owner.lookFor(null);
    assertTrue(owner.lookFor("").last.reactions().anew(), "it was looked away meanwhile");
    assertEquals(1, owner.last.reactions().reactions().size());
  }

  @Test
  void ofVeryManyAPartIsTold() {
    program.say("var Global.x = 0|; for (var i : 2000) at (x == 1) x; at (x == 77) x;");
    assertEquals(2001, owner.lookFor("").last.reactions().total());
    assertEquals(500, owner.reactions.size());
    assertTrue(owner.views > 5, () -> "only " + owner.views + " looks at thousands");
    assertTrue(owner.voidViews > 5, () -> owner.voidViews + " tell nothing, and are not sent");
    owner.lookFor("X == 77");
    assertEquals(1, owner.last.reactions().total());
    assertEquals(1, owner.reactions.size());
  }

  @Test
  void eventsAreEmittedWithAPayloadOfUrbiscript() {
    program.say(
        "var Global.e = Event.new|; var Global.got = []|; at (e?(var a, var b)) got << [a, b];");
    assertEquals("", owner.emit("e", "1 + 1, \"häuser\""));
    assertEquals("[[2, \"h\\xc3\\xa4user\"]]", program.say("got;"));
    assertEquals("", owner.emit("e", ""));
    assertEquals("studio:1.2-12: lookup failed: nobodyKnows", owner.emit("e", "nobodyKnows"));
    assertTrue(owner.emit("e", "1, ").isEmpty(), "a comma more is allowed in lists");
    String unfinished = owner.emit("e", "1 +");
    assertTrue(unfinished.contains("syntax error"), unfinished);
    assertTrue(!unfinished.contains("]"), "of a bracket that nobody has typed: " + unfinished);
    assertTrue(owner.emit("e", "] | 1 | [1][0").contains("emit"), "a number is no payload");
    assertEquals("1", program.say("got.size;"));
    assertEquals(
        "no such event any more: 99999", owner.client.connection().emit(99_999, "1").join());
  }

  @Test
  void whoNeverEndsItsPayloadHoldsNobody() {
    program.say("var Global.e = Event.new|;");
    var pending = owner.client.connection().emit(owner.event("e").number(), "{ loop { 1 } }");
    assertEquals("4", program.say("2 + 2;"));
    assertFalse(pending.isDone());
    owner.client.connection().close();
    assertThrows(CancellationException.class, pending::join);
  }

  @Test
  void observersSeeAndCannotEmit() {
    program.say("var Global.e = Event.new|; var Global.n = 0|; at (e?) n++;");
    Viewer observer = new Viewer(kernel, Role.OBSERVER);
    assertTrue(observer.emit("e", "1").contains("needs the role user"), observer.emit("e", "1"));
    assertEquals("0", program.say("n;"));
    assertEquals("", new Viewer(kernel, Role.USER).emit("e", "1"));
    assertEquals("1", program.say("n;"));
  }

  @Test
  void recordedRunContainsWhatWasEmitted(@TempDir Path folder) {
    Path recording = folder.resolve("run");
    try (Kernel recorded = Kernel.builder().log(line -> {}).record(recording).start()) {
      TestClient coder = new TestClient(recorded, Role.OWNER);
      coder.say("var e = Event.new|; at (e?(var n)) echo(\"got \" + n);");
      Viewer viewer = new Viewer(recorded, Role.OWNER);
      assertEquals("", viewer.emit("e", "17"));
      assertTrue(coder.say("echo(e.uid);").contains("got 17"));
    }
    ReplayedRun.check(recording);
  }
}
