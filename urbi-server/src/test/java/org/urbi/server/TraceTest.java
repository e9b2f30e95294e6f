package org.urbi.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.VirtualClock;

/** What the administrator is told, and how much of what comes again and again. */
class TraceTest {
  private static final long SECOND = 1_000_000_000;

  private final ByteArrayOutputStream written = new ByteArrayOutputStream();
  private final VirtualClock clock = new VirtualClock();
  private final Trace trace =
      new Trace(Trace.Level.LOG, new PrintStream(written, true, StandardCharsets.UTF_8), clock);

  private List<String> lines() {
    return written.toString(StandardCharsets.UTF_8).lines().toList();
  }

  /** A page in somebody's browser can ask the console a thousand times in a second. */
  @Test
  void floodOfClientsThatAreTurnedAwayFillsNoLog() {
    for (int i = 0; i < 1000; i++) {
      trace.turnedAway("client refused: " + i);
    }
    trace.log("something else");
    assertEquals(12, lines().size(), lines().toString());
    assertEquals("urbi: client refused: 9", lines().get(9));
    assertTrue(lines().get(10).contains("more clients"), lines().get(10));
    assertEquals("urbi: something else", lines().get(11));
    clock.advanceTo(2 * SECOND);
    trace.turnedAway("client refused: later");
    assertEquals("urbi: client refused: later", lines().getLast());
  }

  @Test
  void fewAreAllTold() {
    for (int i = 0; i < 100; i++) {
      clock.advanceTo(i * SECOND / 5);
      trace.turnedAway("client refused: " + i);
    }
    assertEquals(100, lines().size());
  }

  @Test
  void whoeverWantsNoLogGetsNone() {
    Trace quiet =
        new Trace(Trace.Level.NONE, new PrintStream(written, true, StandardCharsets.UTF_8), clock);
    quiet.turnedAway("client refused");
    assertEquals(List.of(), lines());
  }
}
