package org.urbi.kernel.embed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.ReplayedRun;

/** A run is replayed without the Java program that was around it. */
class ReplayedProgramTest {
  @TempDir Path folder;

  private void check(Consumer<Kernel> program, String expected) {
    String shown = ReplayedRun.recorded(folder.resolve("run"), program);
    assertTrue(shown.contains(expected), shown);
    assertEquals(shown, ReplayedRun.replayed(folder.resolve("run")));
  }

  @Test
  void evaluationsAndCallsAreDoneAgain() {
    check(
        kernel -> {
          kernel.eval("var n = 1; function add(x) { n += x; sleep(1s) | echo(\"n: \" + n) | n }");
          assertEquals(43.0, kernel.call("add", 42));
          kernel.call("lobby.add", Duration.ofMillis(500));
          kernel.eval("function show(x) { echo(x.asString) }");
          kernel.call("show", List.of("na\u00efve", 'c', true, 1L, Map.of("k", new int[] {1, 2})));
          kernel.call("show", (Object) null);
          kernel.call("show", (Object) new byte[] {65, -1});
          assertThrows(UrbiError.class, () -> kernel.eval("echo(\"before\"); throw 1"));
          assertEquals(3.0, kernel.evalAsync("sleep(2s); echo(\"asynchronous\"); 3").join());
        },
        "n: 43");
  }

  @Test
  void handlesNameTheSameObjectsAgain() {
    check(
        kernel -> {
          var robot =
              kernel.eval(
                  "class Robot { var x = 1; function go(d) { x += d; this } };"
                      + " [Robot, Robot.new()]",
                  List.class);
          UrbiValue made = (UrbiValue) robot.get(1);
          made.set("y", 7);
          made.call("go", 5);
          assertEquals(6.0, made.get("x"));
          assertTrue(made.has("y"));
          made.remove("y");
          assertEquals(List.of("x"), made.slotNames());
          kernel.eval("function tell(o) { echo(\"x: \" + o.x) }");
          kernel.call("tell", made);
          UrbiValue function = kernel.eval("getSlot(\"tell\")", UrbiValue.class);
          function.apply(made);
          assertNotNull(made.toString());
          UrbiValue scope = kernel.embedding().newScope();
          kernel.embedding().eval("var own = 3; echo(own)", "file.u", scope, Object.class);
        },
        "x: 6");
  }

  @Test
  void listenersAreMissedByNobody() throws Exception {
    CompletableFuture<List<Object>> heard = new CompletableFuture<>();
    check(
        kernel -> {
          kernel.eval("var Global.e = Event.new(); var Global.v = 0");
          ListenerRegistration events = kernel.onEvent("e", heard::complete);
          ListenerRegistration changes = kernel.onChange("v * 2", value -> {});
          kernel.eval("e!(1, Object.new()); v = 4");
          heard.join();
          events.close();
          changes.close();
          kernel.eval("echo(\"has subscribers: \" + e.hasSubscribers); v = 5");
        },
        "has subscribers: false");
  }

  @Test
  void whatIsCancelledEndsAgain() {
    check(
        kernel -> {
          CompletableFuture<Object> endless =
              kernel.evalAsync("echo(\"began\"); sleep(inf); echo(\"never\")");
          kernel.eval("sleep(1s); echo(\"between\")");
          endless.cancel(false);
          assertThrows(CancellationException.class, endless::join);
          kernel.eval("sleep(1s); echo(\"after\")");
        },
        "after");
  }

  @Test
  void whatIsEndedForWantOfMemoryEndsAgainAndNothingElse() {
    check(
        kernel -> {
          CompletableFuture<Object> greedy =
              kernel.evalAsync("echo(\"began\"); sleep(inf); echo(\"never\")");
          kernel.eval("sleep(1s); echo(\"between\")");
          kernel.embedding().evictable().evict("no memory");
          assertThrows(CompletionException.class, greedy::join);
          kernel.eval("sleep(1s); echo(\"after\")");
        },
        "after");
  }

  /** It may do anything, and there is nobody who could do it. */
  @Test
  void aReplayEndsAtAFunctionOfTheProgram() throws IOException {
    ReplayedRun.recorded(
        folder.resolve("run"),
        kernel -> {
          kernel.eval("echo(1)");
          kernel.define("two", arguments -> 2);
          kernel.eval("echo(two)");
        });
    StringBuffer shown = new StringBuffer();
    String difference =
        ReplayedRun.difference(Kernel.builder().output(shown::append), folder.resolve("run"));
    assertTrue(
        difference.contains("a replay cannot do FunctionDefined[number=2, name=two]"), difference);
    assertTrue(shown.toString().endsWith("*** 1\n"), shown.toString());
  }
}
