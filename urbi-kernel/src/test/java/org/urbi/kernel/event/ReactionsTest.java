package org.urbi.kernel.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.TestClient;
import org.urbi.kernel.Viewer;
import org.urbi.kernel.observe.EventRow;
import org.urbi.kernel.observe.ReactionRow;
import org.urbi.kernel.trust.Role;

/** What is known of each kind of reaction, and of events: how often, when, and what it read. */
class ReactionsTest {
  private final Kernel kernel = Kernel.builder().log(line -> {}).virtualTime(true).start();
  private final TestClient program = new TestClient(kernel, Role.OWNER);
  private final Viewer viewer = new Viewer(kernel, Role.OWNER);

  @AfterEach
  void close() {
    kernel.close();
  }

  /** Kind, code, how often, when last in milliseconds, what was read. */
  private String seen() {
    viewer.lookFor("");
    return viewer.reactions.values().stream()
        .map(row ->
            "%s %s | %d, %d ms %s"
                .formatted(row.kind(), row.code(), row.times(), row.last() / 1_000_000, row.read()))
        .sorted()
        .collect(Collectors.joining("\n", "", "\n"));
  }

  @Test
  void conditionsAreKnownByWhatTheyRead() {
    program.say(
        """
        var Global.x = 0|; var Global.y = 0|; sleep(10ms);
        at (x + y == 3) y; whenever (x == 1 && y) y, waituntil (x == 9),
        """);
    program.say("sleep(10ms); x = 3; sleep(10ms); y = 1; sleep(5ms);");
    assertEquals(
        """
        at at (x + y == 3) y | 1, 20 ms [x, y]
        whenever whenever (x == 1 && y) y | 0, 0 ms [x]
        """,
        seen()
            .lines()
            .filter(line -> !line.startsWith("waituntil"))
            .collect(Collectors.joining("\n", "", "\n")));
  }

  @Test
  void repetitionsCountTheirTurns() {
    program.say("var Global.t = Tag.new|; t: every (20ms) 1, sleep(50ms); t.freeze;");
    assertEquals("every every (20ms) 1 | 3, 40 ms []\n", seen());
    assertTrue(viewer.reactions.values().iterator().next().frozen());
  }

  @Test
  void handlersOfEventsCountWhatTheyHear() {
    program.say(
        """
        var Global.e = Event.new|; at (e?(var n)) n; whenever (e?(7)) sleep(1h),
        """);
    program.say("sleep(5ms); e!(1); sleep(5ms); e!(2); sleep(5ms);");
    assertEquals(
        """
        at at (e?(var n)) n | 2, 10 ms [e]
        whenever whenever (e?(7)) sleep(1h) | 0, 0 ms [e]
        """,
        seen());
    EventRow event =
        viewer.events.values().stream()
            .filter(row -> row.name().equals("e"))
            .findFirst()
            .orElseThrow();
    assertEquals(
        List.of(2, 2L, 10L), List.of(event.listeners(), event.times(), event.last() / 1_000_000));
  }

  @Test
  void watchedExpressionsAreReactions() {
    program.say("var Global.x = 0|; var Global.w = watch(x * 2)|;");
    viewer.lookFor("");
    ReactionRow watching = viewer.reactions.values().iterator().next();
    assertEquals("watch", watching.kind());
    assertEquals(List.of("x"), watching.read());
  }

  @Test
  void stoppedReactionsAreKnownNoLonger() {
    program.say(
        """
        var Global.x = 0|; var Global.e = Event.new|;
        var Global.t = Tag.new|; t: at (x == 1) x; t: at (e?) x; t: whenever (x == 2) x, t: whenever (e?) x,
        t: every (1h) x, sleep(1ms);
        t.freeze;
        """);
    viewer.lookFor("");
    assertEquals(5, viewer.reactions.size());
    program.say("t.stop;");
    viewer.lookFor("");
    assertEquals(Map.of(), viewer.reactions);
  }
}
