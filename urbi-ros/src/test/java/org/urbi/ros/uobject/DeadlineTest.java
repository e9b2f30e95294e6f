package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

class DeadlineTest {
  private long now;
  private final List<Long> waits = new ArrayList<>();
  private final Deque<CompletableFuture<Void>> timers = new ArrayDeque<>();
  private final List<Long> told = new ArrayList<>();

  private Deadline deadline(Duration period) {
    return new Deadline(
        period,
        () -> told.add(now),
        () -> now,
        wait -> {
          waits.add(wait);
          // What follows is done by the thread of the test.
          CompletableFuture<Void> timer =
              new CompletableFuture<>() {
                @Override
                public CompletableFuture<Void> thenRunAsync(Runnable action) {
                  return thenRun(action);
                }
              };
          timers.add(timer);
          return timer;
        });
  }

  /** The time of the newest timer has come. */
  private void pass() {
    now += waits.getLast();
    timers.removeLast().complete(null);
  }

  @Test
  void nothingIsMissedBeforeTheFirstMessage() {
    deadline(Duration.ofMillis(5));
    assertTrue(timers.isEmpty());
  }

  @Test
  void whoStopsIsToldOfAgainAndAgain() {
    Deadline deadline = deadline(Duration.ofMillis(5));
    deadline.heard();
    pass();
    pass();
    assertEquals(List.of(5_000_000L, 10_000_000L), told);
  }

  @Test
  void whoIsInTimeIsNot() {
    Deadline deadline = deadline(Duration.ofMillis(5));
    deadline.heard();
    now += 3_000_000;
    deadline.heard();
    now = 0;
    pass();
    assertEquals(List.of(), told);
    assertEquals(3_000_000L, waits.getLast());
    pass();
    assertEquals(List.of(8_000_000L), told);
  }

  @Test
  void withoutADeadlineNothingWaits() {
    Deadline deadline = deadline(Duration.ZERO);
    deadline.heard();
    deadline.end();
    assertTrue(timers.isEmpty());
  }

  @Test
  void noTimeAtAllDoesNotFillTheKernel() {
    Deadline deadline = deadline(Duration.ofNanos(1));
    deadline.heard();
    assertEquals(List.of(Deadline.SHORTEST), waits);
  }

  @Test
  void theEndLeavesNothingThatWaits() {
    Deadline deadline = deadline(Duration.ofDays(10_000));
    deadline.heard();
    deadline.end();
    assertTrue(timers.removeLast().isCancelled());
    deadline.heard();
    assertEquals(1, waits.size());
    assertEquals(List.of(), told);
  }
}
