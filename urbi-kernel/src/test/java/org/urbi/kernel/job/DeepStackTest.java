package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;

/** When a stack that is too deep to let others run is tried again. */
class DeepStackTest {
  private static final long MILLISECOND = 1_000_000;

  private final ManualClock machine = ManualClock.real();
  private long turn;
  private final DeepStack stack = new DeepStack(() -> turn, Journal.NONE, machine);

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

  /** What a journal is asked and told of switches. */
  private static final class Switches implements Journal {
    private final Deque<Boolean> recorded = new ArrayDeque<>();
    private int refused;

    @Override
    public boolean countsChecks() {
      return true;
    }

    @Override
    public boolean refusesSwitch() {
      return recorded.remove();
    }

    @Override
    public void switchRefused() {
      refused++;
    }

    @Override
    public boolean triesSwitchAgain(boolean wanted) {
      return recorded.remove();
    }
  }

  @Test
  void whatWasRefusedInTheRecordedRunIsRefused() {
    Switches journal = new Switches();
    DeepStack replayed = new DeepStack(() -> turn, journal, machine);
    Collections.addAll(journal.recorded, false, true);
    replayed.refuseAsRecorded();
    replayed.failed(assertThrows(StackOverflowError.class, replayed::refuseAsRecorded));
    assertEquals(0, journal.refused, "the recording has it");
    replayed.failed(new StackOverflowError());
    replayed.failed(new IllegalStateException());
    assertEquals(1, journal.refused);
  }

  @Test
  void itIsTriedAgainWhenItWasInTheRecordedRun() {
    Switches journal = new Switches();
    DeepStack replayed = new DeepStack(() -> turn, journal, machine);
    Collections.addAll(journal.recorded, false, true);
    assertTrue(replayed.mayBePutAway());
    replayed.refused();
    assertFalse(replayed.mayBePutAway());
    assertTrue(replayed.mayBePutAway());
  }
}
