package org.urbi.ros.rcl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Nobody waits for the middleware silently, or for ever. */
class PatienceTest {
  private static final Duration SECOND = Duration.ofSeconds(1);

  private final List<String> events = new ArrayList<>();

  /** Comes after that time; it takes notice of how long somebody waits. */
  private Patience.Awaited after(Duration needed) {
    Duration[] left = {needed};
    return time -> {
      events.add("waits " + time.toSeconds());
      left[0] = left[0].minus(time);
      return !left[0].isPositive();
    };
  }

  private boolean comes(Duration needed) throws InterruptedException {
    return Patience.USUAL.await(after(needed), () -> events.add("told"));
  }

  @Test
  void whatComesSoonIsNotTold() throws Exception {
    assertTrue(comes(SECOND));
    assertEquals(List.of("waits 1"), events);
  }

  @Test
  void whatTakesLongerIsTold() throws Exception {
    assertTrue(comes(SECOND.multipliedBy(5)));
    assertEquals(List.of("waits 1", "told", "waits 4"), events);
  }

  @Test
  void whatDoesNotComeIsGivenUp() throws Exception {
    assertFalse(comes(SECOND.multipliedBy(6)));
    assertEquals(List.of("waits 1", "told", "waits 4"), events);
  }
}
