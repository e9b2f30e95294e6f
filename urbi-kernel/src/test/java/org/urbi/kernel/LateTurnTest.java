package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.Clock;

/** Turns of {@code every} in a kernel that is held up, in simulated time. */
class LateTurnTest {
  /** The kernel catches up with the turns that were due meanwhile. */
  @Test
  void aTurnThatComesLateDoesNotMoveTheNext() {
    try (Kernel kernel = Kernel.builder().virtualTime(true).start()) {
      Clock clock = kernel.scheduler().clock();
      kernel.define(
          "holdUp",
          nothing -> {
            clock.advanceTo(clock.now() + 30_000_000);
            return null;
          });
      String turns =
          kernel.eval(
              """
              var Global.turns = 0;
              var Global.begin = time;
              every (5ms) turns++,
              for (4) { sleep(5ms); holdUp };
              sleep(32ms);
              "%s turns in %s ms" % [turns, ((time - begin) * 1000).round];
              """,
              String.class);
      // The first one is at the beginning; each late turn that moved the next would cost five.
      assertEquals("34 turns in 167 ms", turns);
    }
  }
}
