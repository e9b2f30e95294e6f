package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.StopReason;
import org.urbi.kernel.object.UrbiObject;

/** The flags for code that never lets others run, which no message can reach. */
class InterruptionsTest {
  private static final long FAREWELL = 50_000_000;

  private final ManualClock machine = ManualClock.real();
  private final Loop loop = new Loop();
  private final UrbiObject lobby = loop.object();
  private final UrbiObject other = loop.object();
  private long turn = 7;
  private int changes;
  private final Interruptions interruptions = new Interruptions(() -> turn, Journal.NONE, machine);

  @Test
  void nobodyEndsByHimself() {
    assertFalse(interruptions.arePending());
    assertEquals(StopReason.NONE, interruptions.decide(lobby));
    assertEquals(StopReason.NONE, interruptions.decide(null));
    assertFalse(interruptions.isMessageDue(lobby));
  }

  @Test
  void whoIsInterruptedIsSoOnce() {
    interruptions.request(lobby);
    interruptions.request(other);
    assertTrue(interruptions.arePending());
    assertEquals(StopReason.NONE, interruptions.decide(null));
    assertEquals(StopReason.REQUESTED, interruptions.decide(lobby));
    assertTrue(interruptions.isMessageDue(lobby));
    assertFalse(interruptions.isMessageDue(other));
    turn++;
    assertEquals(StopReason.NONE, interruptions.decide(lobby));
    assertTrue(interruptions.arePending());
    interruptions.clear(other);
    assertFalse(interruptions.arePending());
    interruptions.clear(lobby);
    assertFalse(interruptions.isMessageDue(lobby));
  }

  @Test
  void whatEndsHasAMomentToCleanUpAndNoMore() {
    interruptions.requestOverdue(turn, StopReason.OVERDUE);
    assertTrue(interruptions.arePending());
    assertEquals(StopReason.OVERDUE, interruptions.decide(lobby));
    machine.now = FAREWELL - 1;
    assertEquals(StopReason.NONE, interruptions.decide(lobby));
    machine.now = FAREWELL;
    assertEquals(StopReason.OVERDUE, interruptions.decide(lobby));
    assertTrue(interruptions.arePending());
    turn++;
    assertEquals(StopReason.NONE, interruptions.decide(lobby));
    assertFalse(interruptions.arePending());
  }

  @Test
  void whatEndsBecauseItsClientWantsItHasNoMoreThanThatEither() {
    interruptions.request(lobby);
    assertEquals(StopReason.REQUESTED, interruptions.decide(lobby));
    machine.now = FAREWELL;
    assertEquals(StopReason.REQUESTED, interruptions.decide(lobby));
  }

  @Test
  void theTurnThatIsOverdueIsNotTheNext() {
    interruptions.requestOverdue(turn - 1, StopReason.OVERDUE);
    assertEquals(StopReason.NONE, interruptions.decide(lobby));
    interruptions.requestOverdue(turn, StopReason.OVERDUE);
    assertEquals(StopReason.OVERDUE, interruptions.decide(lobby));
    turn++;
    interruptions.requestOverdue(turn, StopReason.OVERDUE);
    assertEquals(StopReason.OVERDUE, interruptions.decide(lobby));
  }

  @Test
  void whenTheKernelEndsEverybodyEndsAgainAndAgain() {
    interruptions.requestAll();
    assertTrue(interruptions.arePending());
    assertEquals(StopReason.REQUESTED, interruptions.decide(lobby));
    assertFalse(interruptions.isMessageDue(lobby));
    turn++;
    assertEquals(StopReason.REQUESTED, interruptions.decide(null));
    turn++;
    assertEquals(StopReason.REQUESTED, interruptions.decide(lobby));
    interruptions.clear(lobby);
    assertTrue(interruptions.arePending());
  }

  @Test
  void whoIsConcernedIsToldOfEachChange() {
    interruptions.whenChanged(() -> changes++);
    assertEquals(1, changes);
    interruptions.request(lobby);
    assertEquals(2, changes);
    interruptions.requestOverdue(turn, StopReason.OVERDUE);
    assertEquals(3, changes);
    interruptions.requestAll();
    assertEquals(4, changes);
    interruptions.clear(lobby);
    assertEquals(5, changes);
  }

  @Test
  void whoLetsOthersRunWhileHeEndsGoesOnToEnd() {
    assertNull(interruptions.pause());
    interruptions.resume(null);
    assertFalse(interruptions.arePending());
    interruptions.request(lobby);
    assertEquals(StopReason.REQUESTED, interruptions.decide(lobby));
    machine.now = 20_000_000;
    Interruptions.Termination paused = interruptions.pause();
    assertNotNull(paused);
    turn++;
    assertNull(interruptions.pause());
    // Another job runs, which is not to end.
    assertEquals(StopReason.NONE, interruptions.decide(other));
    assertFalse(interruptions.arePending());
    turn++;
    interruptions.resume(paused);
    assertTrue(interruptions.arePending());
    machine.now = FAREWELL - 1;
    assertEquals(StopReason.NONE, interruptions.decide(lobby));
    machine.now = FAREWELL;
    assertEquals(StopReason.REQUESTED, interruptions.decide(lobby));
  }

  @Test
  void codeIsLeftByWhatFits() {
    Job job = loop.idle(lobby);
    interruptions.check(job);
    interruptions.request(lobby);
    TagStop stop = assertThrows(TagStop.class, () -> interruptions.check(job));
    assertTrue(stop.isInterruption());
    assertNull(stop.scope());
    turn++;
    interruptions.requestOverdue(turn, StopReason.OVERDUE);
    stop = assertThrows(TagStop.class, () -> interruptions.check(job));
    assertFalse(stop.isInterruption());
  }

  @Test
  void whatIsOverdueIsLeftByTheSameFailureUntilItHasEnded() {
    Job job = loop.idle(lobby);
    interruptions.setLimitFailure((overdue, why) -> new IllegalStateException(overdue.name()));
    interruptions.requestOverdue(turn, StopReason.OVERDUE);
    var first = assertThrows(IllegalStateException.class, () -> interruptions.check(job));
    assertEquals(job.name(), first.getMessage());
    interruptions.check(job);
    machine.now = FAREWELL;
    assertSame(first, assertThrows(IllegalStateException.class, () -> interruptions.check(job)));
    turn++;
    interruptions.requestOverdue(turn, StopReason.OVERDUE);
    var second = assertThrows(IllegalStateException.class, () -> interruptions.check(job));
    assertFalse(first == second);
  }

  @Test
  void aRecordingIsAskedAlwaysAndDecides() {
    Interruptions recorded =
        new Interruptions(
            () -> turn,
            new Journal() {
              @Override
              public boolean countsChecks() {
                return true;
              }

              @Override
              public StopReason stopReason(StopReason wanted) {
                return StopReason.OVERDUE;
              }
            },
            machine);
    assertTrue(recorded.arePending());
    assertEquals(StopReason.OVERDUE, recorded.decide(lobby));
    recorded.clear(lobby);
    assertTrue(recorded.arePending());
  }
}
