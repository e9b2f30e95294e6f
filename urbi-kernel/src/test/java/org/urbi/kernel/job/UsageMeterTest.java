package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Budgeted;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.object.UrbiObject;

/** What the jobs of a lobby take, and may take. */
class UsageMeterTest {
  private static final int MEGABYTE = 1 << 20;

  private final ManualClock machine = ManualClock.real();

  /** What other threads have allocated, on which the loop was before. */
  private long elsewhere;

  private final UsageMeter meter =
      new UsageMeter(machine, () -> elsewhere + ThreadCosts.allocatedBytes(Thread.currentThread()));
  private final Budget one = new Budget();
  private final Budget other = new Budget();
  private final List<Object> allocated = new ArrayList<>();
  private final Loop loop = new Loop();
  private final Rich lobby = new Rich();

  /** A lobby with a budget. */
  private final class Rich extends UrbiObject implements Budgeted {
    Rich() {
      super(loop.world.orphanShape());
    }

    @Override
    public Budget budget() {
      return one;
    }
  }

  private Job start(UrbiObject of, Job.Body body) {
    return loop.scheduler.startDetached(of, loop.scheduler.rootScope(), "job", body);
  }

  // ------------------------------------------------------------------ measured

  @Test
  void nothingIsMeasuredBeforeSomebodyWantsToKnow() {
    meter.turnOf(one);
    machine.now = 30;
    meter.turnOf(other);
    assertEquals(0, meter.nanoseconds(one));
    assertEquals(0, meter.nanoseconds(other));
    assertEquals(0, meter.bytes(other));
  }

  @Test
  void eachTurnIsOnTheBudgetOfItsJob() {
    machine.now = 100;
    meter.turnOf(null);
    meter.begin();
    machine.now = 110;
    meter.turnOf(one);
    machine.now = 130;
    assertEquals(20, meter.nanoseconds(one));
    assertEquals(0, meter.nanoseconds(other));
    meter.turnOf(other);
    machine.now = 137;
    meter.begin();
    assertEquals(20, meter.nanoseconds(one));
    assertEquals(7, meter.nanoseconds(other));
    meter.turnOf(one);
    machine.now = 140;
    assertEquals(23, meter.nanoseconds(one));
    meter.turnOf(null);
    machine.now = 200;
    assertEquals(23, meter.nanoseconds(one));
    assertEquals(7, other.nanoseconds());
  }

  @Test
  void aTurnThatGoesOnCountsFromWhenSomebodyWantsToKnow() {
    meter.turnOf(one);
    machine.now = 40;
    meter.begin();
    machine.now = 45;
    assertEquals(5, meter.nanoseconds(one));
  }

  @Test
  void memoryThatWasAllocatedCounts() {
    meter.turnOf(one);
    allocated.add(new byte[8 * MEGABYTE]);
    meter.begin();
    allocated.add(new byte[4 * MEGABYTE]);
    assertMegabytes(4, meter.bytes(one));
    meter.turnOf(other);
    allocated.add(new byte[2 * MEGABYTE]);
    assertMegabytes(2, meter.bytes(other));
    assertMegabytes(4, meter.bytes(one));
    meter.turnOf(one);
    allocated.add(new byte[MEGABYTE]);
    assertMegabytes(5, meter.bytes(one));
    assertMegabytes(2, meter.bytes(other));
  }

  /** What the test itself allocates is less than half of one. */
  private static void assertMegabytes(int count, long bytes) {
    assertEquals(count, Math.round((double) bytes / MEGABYTE));
  }

  /** A job that keeps its thread has the loop go on in another one. */
  @Test
  void memoryThatWasAllocatedOnAnotherThreadCounts() {
    meter.begin();
    meter.turnOf(one);
    elsewhere += 3 * MEGABYTE;
    assertMegabytes(3, meter.bytes(one));
    meter.turnOf(other);
    elsewhere += 2 * MEGABYTE;
    assertMegabytes(2, meter.bytes(other));
    assertMegabytes(3, meter.bytes(one));
  }

  @Test
  void theLoopSaysWhoseTurnItIs() {
    start(
        lobby,
        job -> {
          loop.scheduler.meter().begin();
          loop.machine.now = 50;
        });
    start(loop.object(), job -> loop.machine.now = 90);
    loop.scheduler.startBehind(
        lobby, loop.scheduler.rootScope(), "job", job -> loop.machine.now = 97);
    loop.scheduler.atEndOfTick(() -> loop.machine.now = 200);
    loop.run();
    assertEquals(57, loop.scheduler.meter().nanoseconds(one));
  }

  @Test
  void whatTheLoopDoesItselfIsOnNobody() {
    loop.scheduler.meter().begin();
    start(
        lobby,
        job -> {
          loop.machine.now = 10;
          job.yieldNow();
          loop.machine.now = 15;
          loop.scheduler.timers().add(0, () -> loop.machine.now = 300);
          job.yieldNow();
          loop.machine.now = 307;
          loop.scheduler.atEndOfTick(() -> loop.machine.now = 500);
          job.yieldNow();
          loop.machine.now = 501;
        });
    loop.run();
    assertEquals(15 + 7 + 1, loop.scheduler.meter().nanoseconds(one));
  }

  /** However short the turns are, and however they alternate with those of others. */
  @Test
  void manyShortTurnsCountAsMuchAsALongOne() {
    loop.scheduler.meter().begin();
    for (int i = 0; i < 3; i++) {
      start(lobby, job -> useInTurns(job, 100, 1));
      start(lobby, job -> useInTurns(job, 50, 2));
      start(loop.object(), job -> useInTurns(job, 70, 1000));
    }
    loop.run();
    assertEquals(3 * 100 + 3 * 50 * 2, loop.scheduler.meter().nanoseconds(one));
    assertEquals(300 + 300, one.nanoseconds());
  }

  private void useInTurns(Job job, int turns, int nanoseconds) {
    for (int i = 0; i < turns; i++) {
      loop.machine.now += nanoseconds;
      job.yieldNow();
    }
  }

  @Test
  void memoryOfManyShortTurnsCounts() {
    loop.scheduler.meter().begin();
    for (int i = 0; i < 4; i++) {
      start(lobby, job -> allocateInTurns(job, 8));
      start(loop.object(), job -> allocateInTurns(job, 4));
    }
    loop.run();
    assertMegabytes(4 * 8, loop.scheduler.meter().bytes(one));
  }

  private void allocateInTurns(Job job, int megabytes) {
    for (int i = 0; i < megabytes; i++) {
      allocated.add(new byte[MEGABYTE]);
      job.yieldNow();
    }
    allocated.clear();
  }

  /** A lobby that waits uses nothing, whatever becomes of the time. */
  @Test
  void whoWaitsUsesNothing() {
    loop.scheduler.meter().begin();
    start(
        lobby,
        job -> {
          loop.machine.now = 5;
          loop.scheduler.timers().add(Loop.SECOND, () -> loop.machine.now += 1000);
          job.sleepUntil(Loop.SECOND);
          loop.machine.now += 7;
          loop.post(() -> loop.machine.now += 1000);
          job.yieldNow();
          job.yieldNow();
          loop.machine.now += 1;
        });
    loop.run();
    loop.machine.now += 1000;
    assertEquals(5 + 7 + 1, loop.scheduler.meter().nanoseconds(one));
  }

  /** Between the turns it is nobody's, though the time may still count for the lobby. */
  @Test
  void theTurnIsThatOfTheJobThatRuns() {
    start(
        lobby,
        job -> {
          assertTrue(loop.scheduler.isTurnOf(one));
          assertFalse(loop.scheduler.isTurnOf(other));
          loop.scheduler.atEndOfTick(
              () -> loop.say(loop.scheduler.isTurnOf(one) ? "somebody's" : "nobody's"));
          job.yieldNow();
        });
    assertFalse(loop.scheduler.isTurnOf(one));
    assertEquals(List.of("nobody's"), loop.run());
    assertFalse(loop.scheduler.isTurnOf(one));
  }

  // ------------------------------------------------------------------ counted

  @Test
  void jobsCountUntilTheyEnd() {
    Job job = start(lobby, self -> assertEquals(1, one.used(Resource.JOBS)));
    assertSame(one, job.budget());
    assertSame(loop.idle(null).budget(), loop.idle(loop.object()).budget());
    loop.run();
    assertEquals(0, one.used(Resource.JOBS));
  }

  @Test
  void whoStartsAJobTooManyIsLeft() {
    loop.scheduler.setRefusals(
        (problem, places) -> new IllegalArgumentException(problem.name() + List.of(places)));
    one.setLimit(Resource.JOBS, 1);
    start(
        lobby,
        job -> {
          var refusal =
              assertThrows(IllegalArgumentException.class, () -> start(lobby, child -> {}));
          assertEquals(Problem.BUDGET_EXHAUSTED.name() + "[1, jobs]", refusal.getMessage());
          loop.say("refused");
        });
    assertEquals(List.of("refused"), loop.run());
    assertEquals(0, one.used(Resource.JOBS));
  }

  /** Nobody who did it, so the job itself is told. */
  @Test
  void aJobTooManyThatAnotherLobbyStartsEndsItself() {
    IllegalArgumentException refusal = new IllegalArgumentException();
    loop.scheduler.setRefusals((problem, places) -> refusal);
    one.setLimit(Resource.JOBS, 0);
    start(lobby, job -> loop.say("never"));
    start(loop.object(), job -> start(lobby, child -> loop.say("never either")));
    assertThrows(AssertionError.class, loop::run);
    assertEquals(List.of(refusal, refusal), loop.uncaught);
    assertEquals(List.of(), loop.said);
    assertEquals(0, one.used(Resource.JOBS));
  }

  @Test
  void timersCountUntilTheyAreDoneOrCancelled() {
    loop.scheduler.setRefusals((problem, places) -> new IllegalArgumentException());
    one.setLimit(Resource.TIMERS, 2);
    Timers timers = loop.scheduler.timers();
    timers.add(0, () -> {});
    assertEquals(0, one.used(Resource.TIMERS));
    start(
        lobby,
        job -> {
          Timers.Timer first = timers.add(Loop.SECOND, () -> {});
          timers.add(Loop.SECOND, () -> {});
          assertThrows(IllegalArgumentException.class, () -> timers.add(Loop.SECOND, () -> {}));
          first.cancel();
          first.cancel();
          assertEquals(1, one.used(Resource.TIMERS));
          job.sleepUntil(2 * Loop.SECOND);
          assertEquals(0, one.used(Resource.TIMERS));
          assertTrue(one.allows(Resource.TIMERS, 2));
          assertFalse(one.allows(Resource.TIMERS, 3));
          loop.say("done");
        });
    assertEquals(List.of("done"), loop.run());
  }
}
