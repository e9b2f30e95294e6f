package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.trust.Role;

/** What code does to clean up when its client has left runs to its end, and leaves nothing. */
class LastClausesTest {
  private final Kernel kernel = Kernel.builder().virtualTime(true).start();
  private final TestClient judge = new TestClient(kernel, Role.OWNER);

  @AfterEach
  void close() {
    kernel.close();
  }

  /** A client sends that, and leaves while it runs; then time goes by. */
  private void visit(String program) {
    visit(program, "sleep(10s)");
  }

  private void visit(String program, String meanwhile) {
    judge.say("var Global.e = Event.new; var Global.told = []; var Global.f = Event.new;");
    TestClient client = new TestClient(kernel, Role.OWNER);
    client.connection().send(program + "\n");
    judge.say("sleep(1s);");
    client.connection().close();
    judge.say(meanwhile + ";");
  }

  private int jobs() {
    return Integer.parseInt(judge.say("System.jobs.size;"));
  }

  private static String ending(String clause) {
    return "try { sleep(inf) } finally { " + clause + " };";
  }

  static Stream<String> beginnings() {
    return Stream.of(
        "whenever (true) { sleep(1s) }",
        "spawn(function () { sleep(inf) }, false)",
        "detach({ sleep(inf) })",
        "detach({ loop { sleep(1s) } }) | sleep(1s)",
        "at (Global.e?) { sleep(inf) } | Global.e! | sleep(1s)",
        "at (Global.e? ~ 1s) sleep(inf); Global.e! ~ 2s",
        "at (Global.told.size == 0 ~ 1s) { sleep(inf) } | sleep(3s)",
        "var t = Tag.new | t: detach({ sleep(inf) })",
        "var t = Tag.new | t: { at (true) { sleep(inf) } onleave { sleep(inf) } } | sleep(1s) | t.stop",
        "detach({ try { sleep(inf) } finally { detach({ sleep(inf) }) } }) | sleep(1s)",
        "detach({ try { sleep(inf) } finally { sleep(1s) | whenever (true) sleep(1s) } }) | sleep(1s)",
        "for (var i : [1, 2]) { detach({ sleep(inf) }) | break }",
        "for& (var i : [1, 2]) { detach({ sleep(inf) }) }",
        "{ detach({ sleep(inf) }) } & sleep(1s)",
        "function f() { at (Global.e?) {} | detach({ sleep(inf) }); 1 } | f",
        "Global.e.onEvent(function (var e, var p) { 1 }, function (var e, var p, var r) { sleep(inf) }) | Global.e!",
        "eval(\"sleep(inf), 1\")");
  }

  @ParameterizedTest
  @MethodSource("beginnings")
  void whatAClauseBeginsEndsWithIt(String clause) {
    visit(ending(clause));
    assertEquals(1, jobs());
    judge.say("Global.e!; sleep(1s);");
    assertEquals(1, jobs(), "a handler is left");
    assertEquals("false", judge.say("Global.e.hasSubscribers;"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "CLAUSE,",
        "var t = Tag.new|; t: { CLAUSE },",
        "detach({ CLAUSE });",
        "sleep(inf) & { CLAUSE };",
        "loop { detach({ sleep(inf) }) | CLAUSE };",
        "var t = Tag.new|; t: { CLAUSE }, sleep(500ms); t.freeze;",
        "var t = Tag.new|; t: { loop { CLAUSE } }, sleep(500ms); t.freeze; t: {},",
        "try { CLAUSE } finally { try { 1 } finally { detach({ sleep(inf) }) } | sleep(1s) };",
        "at (Global.f?) { CLAUSE }; Global.f!; sleep(inf);",
        "disown({ lobby.connectionTag: { CLAUSE } });",
        "detach({ CLAUSE }); sleep(500ms); lobby.quit;",
        "try { sleep(inf) } finally { { CLAUSE } & { sleep(1s) | throw 1 } };",
      })
  void whereverTheClauseIs(String around) {
    String clause = "try { sleep(inf) } finally { detach({ sleep(inf) }) | at (Global.e?) {} }";
    visit(around.replace("CLAUSE", clause));
    assertEquals(1, jobs());
    assertEquals("false", judge.say("Global.e.hasSubscribers;"));
  }

  /** Cleaning up may take time, and jobs of its own. */
  @Test
  void aClauseRunsToItsEnd() {
    visit(
        ending(
            "at (Global.e?) { Global.told << 1 };"
                + " Global.e!; sleep(1s);"
                + " { sleep(1s) | Global.told << 2 } & { sleep(2s) | Global.told << 3 };"
                + " var j = detach({ sleep(1s) | Global.told << 4 }); j.waitForTermination;"
                + " timeout (1s) sleep(inf); { { sleep(1s) | Global.told << 5 }, 1 };"
                + " function f() { every| (1s) return 6 }; Global.told << f()"));
    assertEquals("[1, 2, 3, 4, 5, 6]", judge.say("Global.told;"));
    assertEquals(1, jobs());
  }

  /** In our time very many jobs end in pieces. */
  @Test
  void aCrowdLeavesNothing() {
    try (Kernel real = Kernel.builder().start()) {
      TestClient observer = new TestClient(real, Role.OWNER);
      observer.say("var Global.e = Event.new;");
      TestClient client = new TestClient(real, Role.OWNER);
      client.say(
          "for (3000) detach({ try { sleep(inf) } finally"
              + " { detach({ sleep(inf) }) | at (Global.e?) { sleep(inf) } | sleep(1ms) } });");
      client.connection().close();
      assertEquals(
          "1", observer.say("while (System.jobs.size != 1) sleep(2ms); System.jobs.size;"));
      assertEquals("false", observer.say("Global.e.hasSubscribers;"));
    }
  }

  /** A client that has left will not unfreeze what it has frozen, and others need not. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "var t = Tag.new|; t: { CLAUSE }, sleep(500ms); t.freeze;",
        "var t = Tag.new|; t: { CLAUSE }, sleep(500ms); t.freeze; t.unfreeze; t.freeze;",
        "var t = Tag.new|; var u = Tag.new|; t: u: { CLAUSE }, sleep(500ms); u.freeze; t.freeze;",
        "var t = Tag.new|; t: t: { CLAUSE }, sleep(500ms); t.freeze;",
        "var t = Tag.new|; t: { sleep(inf) & { CLAUSE } }, sleep(500ms); t.freeze;",
        "var t = Tag.new|; t: detach({ CLAUSE }); sleep(500ms); t.freeze;",
        "var t = Tag.new|; t: { at (Global.f?) { CLAUSE } }; Global.f!; sleep(500ms); t.freeze;",
        "var t = Tag.new|; t: { for (var i : [1]) { CLAUSE } }, sleep(500ms); t.freeze; sleep(inf);",
        "{ CLAUSE }, sleep(500ms); lobby.connectionTag.freeze;",
        "freezeif (Global.told.size == 0) { CLAUSE }, sleep(inf);",
        "Global.t: { CLAUSE }, sleep(500ms); Global.t.freeze;",
        "Global.t: { CLAUSE },",
      })
  void aFrozenTagDoesNotKeepItFromItsEnd(String around) {
    judge.say("var Global.t = Tag.new; var Global.begin = Event.new; var Global.end = Event.new;");
    judge.say("Global.t: { waituntil (Global.end?) | Global.told << 2 },");
    String clause =
        "try { sleep(inf) } finally { waituntil (Global.begin?) | { sleep(1s) & sleep(100ms) }"
            + " | var n = 0 | every| (1s) { n += 1 | if (n == 3) break } | Global.told << 1 }";
    visit(
        around.replace("CLAUSE", clause),
        "sleep(1s); Global.t.freeze; Global.begin!; sleep(10s); Global.end!; sleep(1s)");
    assertEquals("[1]", judge.say("Global.told;"));
    assertEquals(2, jobs());
    judge.say("Global.t.unfreeze; Global.end!; sleep(1s);");
    assertEquals("[1, 2]", judge.say("Global.told;"));
    assertEquals(1, jobs());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "t.freeze | sleep(100ms) | Global.told << 1",
        "t.freeze; { sleep(100ms), 1 }; Global.told << 1",
        "detach({ t.freeze; sleep(100ms); Global.told << 1 }) | sleep(1s)",
        "at (Global.e?) { Global.told << 1 }; t.freeze; Global.e!; sleep(100ms)",
        "at (Global.e?) { sleep(100ms) | Global.told << 1 } | t.freeze | Global.e! | sleep(1s)",
        "t.freeze; whenever (Global.told.empty) { sleep(100ms) | Global.told << 1 } | sleep(1s)",
        "detach({ waituntil (Global.e?) | Global.told << 1 }); t.freeze; Global.e!; sleep(1s)",
        "t.freeze; timeout (1s) sleep(inf); Global.told << 1",
        "t.freeze | try { 1 } finally { sleep(100ms) | Global.told << 1 }",
      })
  void aClauseThatFreezesTheTagAroundItEnds(String clause) {
    visit("var t = Tag.new|; t: { " + ending(clause) + " },");
    assertEquals("[1]", judge.say("Global.told;"));
    assertEquals(1, jobs());
    assertEquals("false", judge.say("Global.e.hasSubscribers;"));
  }

  /** It may use tags of its own as always. */
  @Test
  void whatAClauseFreezesInItselfWaits() {
    visit(
        ending(
            "var u = Tag.new | { { u: { sleep(100ms) | Global.told << 2 } }"
                + " & { u.freeze | sleep(1s) | Global.told << 1 | u.unfreeze } }"));
    assertEquals("[1, 2]", judge.say("Global.told;"));
    assertEquals(1, jobs());
  }

  /** Nor does what it leaves frozen there stay. */
  @Test
  void whatItHasFrozenEndsWithIt() {
    visit(ending("var u = Tag.new | u.freeze | detach({ u: sleep(1s) }) | sleep(1s)"));
    assertEquals(1, jobs());
  }

  @Test
  void whatItDisownsGoesOn() {
    visit(ending("disown({ waituntil (Global.e?) | Global.told << 1 })"));
    assertEquals(2, jobs());
    judge.say("Global.e!; sleep(1s);");
    assertEquals("[1]", judge.say("Global.told;"));
  }

  /** A stop by a program is not for good: the clause may begin what it likes. */
  @Test
  void aClauseOfWhatWasStoppedBeginsWhatGoesOn() {
    judge.say("var Global.told = [];");
    judge.say(
        "var t = Tag.new|; t: { try { sleep(inf) } finally"
            + " { detach({ sleep(1s) | Global.told << 1 }) } }, sleep(1s); t.stop; sleep(2s);");
    assertEquals("[1]", judge.say("Global.told;"));
  }

  /** Handlers of others are theirs, whoever sets them off. */
  @Test
  void whatItSetsOffAtOthersGoesOn() {
    judge.say("var Global.e = Event.new; var Global.seen = [];");
    judge.say("at (Global.e?) { sleep(20s) | Global.seen << 1 };");
    TestClient client = new TestClient(kernel, Role.OWNER);
    client.connection().send(ending("Global.e!") + "\n");
    judge.say("sleep(1s);");
    client.connection().close();
    judge.say("sleep(21s);");
    assertEquals("[1]", judge.say("Global.seen;"));
  }
}
