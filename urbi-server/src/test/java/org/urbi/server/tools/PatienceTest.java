package org.urbi.server.tools;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.VirtualClock;

class PatienceTest {
  private final VirtualClock clock = new VirtualClock();

  private Patience patience(long milliseconds) {
    return new Patience(
        clock, pause -> clock.advanceTo(clock.now() + pause), Duration.ofMillis(milliseconds));
  }

  private int tries(Patience patience) {
    int tries = 1;
    while (patience.again()) {
      tries++;
    }
    return tries;
  }

  @Test
  void withoutATimeThereIsOneTry() {
    assertEquals(1, tries(patience(0)));
    assertEquals(0, clock.now());
  }

  /** The last one is at the very end. */
  @Test
  void triesFollowOneAnotherUntilTheTimeIsOver() {
    assertEquals(4, tries(patience(120)));
    assertEquals(120_000_000, clock.now());
  }

  @Test
  void interruptionEndsIt() {
    var patience =
        new Patience(
            clock,
            pause -> {
              throw new InterruptedException();
            },
            Duration.ofSeconds(1));
    assertFalse(patience.again());
    assertTrue(Thread.interrupted());
  }
}
