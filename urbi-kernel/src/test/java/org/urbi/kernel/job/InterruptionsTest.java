package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Ending;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.UrbiObject;

/** The flags for code that never lets others run, which no message can reach. */
class InterruptionsTest {
  private static final long FAREWELL = 50_000_000;

  private final SetClock machine = SetClock.real();
  private final Loop loop = new Loop();
  private final UrbiObject lobby = loop.object();
  private final UrbiObject other = loop.object();
  private long turn = 7;
  private int changes;
  private final Interruptions interruptions = new Interruptions(() -> turn, Journal.NONE, machine);

  @Test
  void nobodyEndsByHimself() {
    assertFalse(interruptions.areWanted());
    assertEquals(Ending.NONE, interruptions.decide(lobby));
    assertEquals(Ending.NONE, interruptions.decide(null));
    assertFalse(interruptions.isMessageDue(lobby));
  }

  @Test
  void whoIsInterruptedIsSoOnce() {
    interruptions.want(lobby);
    interruptions.want(other);
    assertTrue(interruptions.areWanted());
    assertEquals(Ending.NONE, interruptions.decide(null));
    assertEquals(Ending.WANTED, interruptions.decide(lobby));
    assertTrue(interruptions.isMessageDue(lobby));
    assertFalse(interruptions.isMessageDue(other));
    turn++;
    assertEquals(Ending.NONE, interruptions.decide(lobby));
    assertTrue(interruptions.areWanted());
    interruptions.clear(other);
    assertFalse(interruptions.areWanted());
    interruptions.clear(lobby);
    assertFalse(interruptions.isMessageDue(lobby));
  }

  @Test
  void whatEndsHasAMomentToCleanUpAndNoMore() {
    interruptions.wantOverdue(turn);
    assertTrue(interruptions.areWanted());
    assertEquals(Ending.OVERDUE, interruptions.decide(lobby));
    machine.now = FAREWELL - 1;
    assertEquals(Ending.NONE, interruptions.decide(lobby));
    machine.now = FAREWELL;
    assertEquals(Ending.OVERDUE, interruptions.decide(lobby));
    assertTrue(interruptions.areWanted());
    turn++;
    assertEquals(Ending.NONE, interruptions.decide(lobby));
    assertFalse(interruptions.areWanted());
  }

  @Test
  void whatEndsBecauseItsClientWantsItHasNoMoreThanThatEither() {
    interruptions.want(lobby);
    assertEquals(Ending.WANTED, interruptions.decide(lobby));
    machine.now = FAREWELL;
    assertEquals(Ending.WANTED, interruptions.decide(lobby));
  }

  @Test
  void theTurnThatIsOverdueIsNotTheNext() {
    interruptions.wantOverdue(turn - 1);
    assertEquals(Ending.NONE, interruptions.decide(lobby));
    interruptions.wantOverdue(turn);
    assertEquals(Ending.OVERDUE, interruptions.decide(lobby));
    turn++;
    interruptions.wantOverdue(turn);
    assertEquals(Ending.OVERDUE, interruptions.decide(lobby));
  }

  @Test
  void whenTheKernelEndsEverybodyEndsAgainAndAgain() {
    interruptions.wantAll();
    assertTrue(interruptions.areWanted());
    assertEquals(Ending.WANTED, interruptions.decide(lobby));
    assertFalse(interruptions.isMessageDue(lobby));
    turn++;
    assertEquals(Ending.WANTED, interruptions.decide(null));
    turn++;
    assertEquals(Ending.WANTED, interruptions.decide(lobby));
    interruptions.clear(lobby);
    assertTrue(interruptions.areWanted());
  }

  @Test
  void whoIsConcernedIsToldOfEachChange() {
    interruptions.whenChanged(() -> changes++);
    assertEquals(1, changes);
    interruptions.want(lobby);
    assertEquals(2, changes);
    interruptions.wantOverdue(turn);
    assertEquals(3, changes);
    interruptions.wantAll();
    assertEquals(4, changes);
    interruptions.clear(lobby);
    assertEquals(5, changes);
  }

  @Test
  void whoLetsOthersRunWhileHeEndsGoesOnToEnd() {
    assertNull(interruptions.pause());
    interruptions.resume(null);
    assertFalse(interruptions.areWanted());
    interruptions.want(lobby);
    assertEquals(Ending.WANTED, interruptions.decide(lobby));
    machine.now = 20_000_000;
    Interruptions.Farewell paused = interruptions.pause();
    assertNotNull(paused);
    turn++;
    assertNull(interruptions.pause());
    // Another job runs, which is not to end.
    assertEquals(Ending.NONE, interruptions.decide(other));
    assertFalse(interruptions.areWanted());
    turn++;
    interruptions.resume(paused);
    assertTrue(interruptions.areWanted());
    machine.now = FAREWELL - 1;
    assertEquals(Ending.NONE, interruptions.decide(lobby));
    machine.now = FAREWELL;
    assertEquals(Ending.WANTED, interruptions.decide(lobby));
  }

  @Test
  void codeIsLeftByWhatFits() {
    Job job = loop.idle(lobby);
    interruptions.check(job);
    interruptions.want(lobby);
    TagStop stop = assertThrows(TagStop.class, () -> interruptions.check(job));
    assertTrue(stop.isInterruption());
    assertNull(stop.scope());
    turn++;
    interruptions.wantOverdue(turn);
    stop = assertThrows(TagStop.class, () -> interruptions.check(job));
    assertFalse(stop.isInterruption());
  }

  @Test
  void whatIsOverdueIsLeftByTheSameFailureUntilItHasEnded() {
    Job job = loop.idle(lobby);
    interruptions.setOverdueFailure(overdue -> new IllegalStateException(overdue.name()));
    interruptions.wantOverdue(turn);
    var first = assertThrows(IllegalStateException.class, () -> interruptions.check(job));
    assertEquals(job.name(), first.getMessage());
    interruptions.check(job);
    machine.now = FAREWELL;
    assertSame(first, assertThrows(IllegalStateException.class, () -> interruptions.check(job)));
    turn++;
    interruptions.wantOverdue(turn);
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
              public boolean counts() {
                return true;
              }

              @Override
              public Ending stops(Ending wanted) {
                return Ending.OVERDUE;
              }
            },
            machine);
    assertTrue(recorded.areWanted());
    assertEquals(Ending.OVERDUE, recorded.decide(lobby));
    recorded.clear(lobby);
    assertTrue(recorded.areWanted());
  }
}
