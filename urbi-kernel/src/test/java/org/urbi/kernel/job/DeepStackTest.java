package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** When a stack that is too deep to let others run is tried again. */
class DeepStackTest {
  private static final long MILLISECOND = 1_000_000;

  private final ManualClock machine = ManualClock.real();
  private long turn;
  private final DeepStack stack = new DeepStack(() -> turn, machine);

  private void refuseAfter(long milliseconds) {
    assertTrue(stack.mayBePutAway());
    machine.now += milliseconds * MILLISECOND;
    stack.refused();
  }

  private void mayNotBePutAwayFor(long milliseconds) {
    machine.now += milliseconds * MILLISECOND - 1;
    assertFalse(stack.mayBePutAway());
    machine.now += 1;
    assertTrue(stack.mayBePutAway());
  }

  @Test
  void whatHasNotBeenRefusedMayBeTriedAnyTime() {
    assertTrue(stack.mayBePutAway());
    assertTrue(stack.mayBePutAway());
  }

  @Test
  void whatWasRefusedIsTriedAgainAfterSomeTimesWhatThatTook() {
    refuseAfter(5);
    mayNotBePutAwayFor(10);
    refuseAfter(5);
    mayNotBePutAwayFor(20);
    refuseAfter(1);
    mayNotBePutAwayFor(4);
  }

  @Test
  void theNextTurnIsNotToBlame() {
    refuseAfter(5);
    assertFalse(stack.mayBePutAway());
    turn++;
    assertTrue(stack.mayBePutAway());
  }
}
