package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;

/** How a simulated time follows that of the machine. Who waits here does so for no time at all. */
class SimulationPaceTest {
  private static final long SECOND = Loop.SECOND;
  private static final long GRACE = SECOND / 10;

  private final ManualClock simulated = ManualClock.simulated();
  private final ManualClock machine = ManualClock.real();
  private final SimulationPace pace = new SimulationPace(simulated, machine);
  private final Inbox silent = new Inbox(Journal.NONE);
  private final Inbox news = new Inbox(Journal.NONE);
  private boolean open;

  @BeforeEach
  void tell() {
    news.post(new Message.InputEnded(0));
  }

  @Test
  void timeIsRealWhileSomethingRealGoesOn() {
    assertFalse(pace.isReal());
    pace.begin();
    pace.begin();
    assertTrue(pace.isReal());
    pace.end();
    assertTrue(pace.isReal());
    pace.end();
    assertFalse(pace.isReal());
    pace.beginWhile(() -> open);
    assertFalse(pace.isReal());
    open = true;
    assertTrue(pace.isReal());
    open = false;
    assertFalse(pace.isReal());
  }

  @Test
  void whatAnswersSoonTakesNoTime() {
    pace.begin();
    machine.now = GRACE - 1;
    pace.idle(news, Long.MAX_VALUE);
    assertEquals(0, simulated.now());
    machine.now = GRACE;
    pace.idle(news, Long.MAX_VALUE);
    assertEquals(GRACE, simulated.now());
    machine.now = 2 * GRACE - 1;
    pace.idle(news, Long.MAX_VALUE);
    assertEquals(GRACE, simulated.now());
  }

  @Test
  void aDeadlineComesWhenTheMachineHasReachedIt() {
    machine.now = 3 * SECOND;
    pace.begin();
    machine.now = 13 * SECOND;
    pace.idle(silent, 10 * SECOND);
    assertEquals(10 * SECOND, simulated.now());
  }

  @Test
  void timeDoesNotPassTheDeadline() {
    pace.begin();
    machine.now = 13 * SECOND;
    pace.idle(silent, 10 * SECOND);
    assertEquals(10 * SECOND, simulated.now());
  }

  @Test
  void aDeadlineThatWasPassedIsNotWaitedFor() {
    simulated.now = 5 * SECOND;
    pace.begin();
    machine.now = 5 * SECOND;
    pace.idle(silent, 10 * SECOND);
    assertEquals(10 * SECOND, simulated.now());
  }

  @Test
  void whoHasRunAheadDoesNotWaitForTheMachine() {
    pace.begin();
    simulated.now = 5 * SECOND;
    machine.now = SECOND;
    pace.idle(silent, 5 * SECOND);
    assertEquals(5 * SECOND, simulated.now());
    machine.now = 2 * SECOND;
    pace.idle(silent, 6 * SECOND);
    assertEquals(6 * SECOND, simulated.now());
  }

  /** What the machine does between two real things does not count. */
  @Test
  void timesGoTogetherFromWhenSomethingRealBegins() {
    pace.begin();
    pace.end();
    assertFalse(pace.isReal());
    machine.now = 100 * SECOND;
    open = true;
    pace.beginWhile(() -> open);
    assertTrue(pace.isReal());
    machine.now = 101 * SECOND;
    assertTrue(pace.isReal());
    pace.idle(news, Long.MAX_VALUE);
    assertEquals(SECOND, simulated.now());
  }
}
