package org.urbi.kernel.memory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.VirtualClock;

/** What happens when the heap is nearly full, in virtual time. */
class MemoryRescueTest {
  private static final long PERIOD = 250_000_000;
  private static final long SECOND = 1_000_000_000;

  private final VirtualClock clock = new VirtualClock();
  private final StringBuilder events = new StringBuilder();
  private final GivenHeap heap = new GivenHeap();
  private final List<String> logged = new ArrayList<>();
  private final MemoryRescue rescue =
      new MemoryRescue(clock, clock::now, heap, defect -> logged.add(defect.getMessage()));

  @BeforeEach
  void memoryIsFull() {
    heap.full = true;
  }

  /** A kernel with one lobby, whose jobs are ended first, then its client let go. */
  private class Kernel implements MemoryUser {
    private final String name;
    private final double grown;
    private int steps = 2;
    private boolean measured;
    private boolean done;

    Kernel(String name, double grown) {
      this.name = name;
      this.grown = grown;
    }

    @Override
    public void prepare() {}

    @Override
    public void memoryScarce(boolean scarce) {
      measured = scarce;
    }

    @Override
    public double growth() {
      return switch (steps) {
        case 2 -> measured ? grown : 0;
        case 1 -> Double.POSITIVE_INFINITY;
        default -> 0;
      };
    }

    @Override
    public void relieve() {
      steps--;
      tell(steps == 1 ? "ended" : "gone");
    }

    @Override
    public boolean isDone() {
      return done;
    }

    @Override
    public void memoryNearlyFull(boolean is) {
      tell(is ? "full" : "free");
    }

    @Override
    public void memoryExhausted() {
      tell("exhausted");
    }

    void tell(String what) {
      events.append(clock.now() / (double) SECOND).append(' ').append(name).append(' ');
      events.append(what).append('\n');
    }
  }

  private void run(double seconds, MemoryUser... users) {
    long end = clock.now() + (long) (seconds * SECOND);
    while (clock.now() < end) {
      clock.advanceTo(clock.now() + PERIOD);
      rescue.check(users);
    }
  }

  @Test
  void whoHasGrownMostOfAllKernelsGoesFirst() {
    Kernel small = new Kernel("small", 10);
    Kernel large = new Kernel("large", 20);
    Kernel idle = new Kernel("idle", 0);
    run(3, small, large, idle);
    heap.full = false;
    run(1, small, large, idle);
    assertEquals(
        """
        0.25 small full
        0.25 large full
        0.25 idle full
        0.25 large ended
        1.25 large gone
        2.25 small ended
        3.25 small free
        3.25 large free
        3.25 idle free
        """,
        events.toString());
  }

  /** What has been done shows by the next collection; there is nothing to wait for. */
  @Test
  void theNextStepFollowsAtOnceWhenTheLastOneIsDone() {
    Kernel first = new Kernel("first", 20);
    Kernel second = new Kernel("second", 10);
    run(0.25, first, second);
    assertTrue(rescue.isWaiting());
    first.done = true;
    run(0.25, first, second);
    assertEquals(1, heap.collections);
    first.done = false;
    run(0.25, first, second);
    first.done = true;
    heap.whenCollected = () -> heap.full = false;
    run(0.5, first, second);
    assertFalse(rescue.isWaiting());
    assertEquals(
        """
        0.25 first full
        0.25 second full
        0.25 first ended
        0.5 first gone
        1.25 first free
        1.25 second free
        """,
        events.toString());
    assertEquals(2, heap.collections);
  }

  /** Who grows is measured at its own pace, however often it is looked whether memory is free. */
  @Test
  void looksInQuickSuccessionMeasureGrowthOnce() {
    int[] measured = {0};
    Kernel kernel =
        new Kernel("one", 10) {
          @Override
          public void memoryScarce(boolean scarce) {
            super.memoryScarce(scarce);
            measured[0]++;
          }
        };
    rescue.check(new MemoryUser[] {kernel});
    for (int i = 0; i < 19; i++) {
      clock.advanceTo(clock.now() + 10_000_000);
      rescue.check(new MemoryUser[] {kernel});
    }
    assertEquals(1, measured[0]);
    clock.advanceTo(clock.now() + 10_000_000);
    rescue.check(new MemoryUser[] {kernel});
    assertEquals(2, measured[0]);
  }

  @Test
  void memoryThatCannotBeFreedIsToldAndTriedAgainLater() {
    Kernel kernel = new Kernel("one", 10);
    run(20, kernel);
    assertEquals(
        """
        0.25 one full
        0.25 one ended
        1.25 one gone
        5.5 one exhausted
        15.5 one full
        19.75 one exhausted
        """,
        events.toString());
  }

  /** Memory is full for so long, then not, again and again, until that is given up. */
  private String rescueWithPauses(double full, double calm, MemoryUser user) {
    for (int i = 0; i < 40 && !events.toString().contains("exhausted"); i++) {
      heap.full = true;
      run(full, user);
      heap.full = false;
      run(calm, user);
    }
    return events.toString();
  }

  /** Each attempt alone ends before it would be given up, so all of them together must. */
  @Test
  void momentsWithSomeRoomDoNotProlongTheRescueForEver() {
    heap.scarce = true;
    String told = rescueWithPauses(3, 0.5, new Kernel("idle", 0));
    assertTrue(told.contains("\n27.5 idle exhausted\n"), told);
  }

  @Test
  void aRescueThatSucceedsForLongerThanItTakesIsNeverGivenUp() {
    heap.scarce = true;
    String told = rescueWithPauses(3, 3.5, new Kernel("idle", 0));
    assertFalse(told.contains("exhausted"), told);
  }

  @Test
  void whatCameBeforeDoesNotMatterWhenMemoryIsFreeAgain() {
    String told = rescueWithPauses(3, 0.5, new Kernel("idle", 0));
    assertFalse(told.contains("exhausted"), told);
  }

  /**
   * Collections that leave little room, and take much of the time, are measured anew after each
   * step: nobody is let go for those that only look whether it has helped.
   */
  @Test
  void whoeverIsAskedBecauseCollectionsTakeTooLongIsTheOnlyOne() {
    heap.full = false;
    heap.scarce = true;
    heap.slow = true;
    Kernel kernel = new Kernel("one", 10);
    run(5, kernel);
    assertEquals("0.25 one full\n0.25 one ended\n0.5 one free\n", events.toString());
    assertEquals(0, heap.collections);
    events.setLength(0);
    heap.slow = true;
    run(1, kernel);
    assertEquals("5.25 one full\n5.25 one gone\n5.5 one free\n", events.toString());
  }

  /** They are no reason to end the process: it gets on, if slowly. */
  @Test
  void collectionsThatTakeTooLongForNobodyEndNothing() {
    heap.full = false;
    heap.slow = true;
    run(0.25, new Kernel("idle", 0));
    run(30, new Kernel("idle", 0));
    assertEquals("0.25 idle full\n0.5 idle free\n", events.toString());
  }

  /** Nobody asks for a collection when nobody allocates any more. */
  @Test
  void whatWasLeftAsGarbageDoesNotExhaustMemory() {
    heap.whenCollected = () -> heap.full = false;
    run(10, new Kernel("idle", 0));
    assertEquals("0.25 idle full\n4.75 idle free\n", events.toString());
    assertEquals(1, heap.collections);
  }

  /** Garbage may have been collected for the last time before what was ended became garbage. */
  @Test
  void whatBecameGarbageAfterTheLastCollectionDoesNotExhaustMemory() {
    heap.collections = 3;
    heap.whenCollected = () -> heap.full = false;
    Kernel kernel = new Kernel("one", 10);
    run(0.5, kernel);
    heap.collections++;
    run(10, kernel);
    assertEquals("0.25 one full\n0.25 one ended\n1.5 one free\n", events.toString());
    heap.full = true;
    events.setLength(0);
    run(10, new Kernel("idle", 0));
    assertEquals("10.75 idle full\n15.25 idle free\n", events.toString());
  }

  @Test
  void kernelWhoseProgramFailsDoesNotHarmTheOthers() {
    Kernel failing =
        new Kernel("failing", 0) {
          @Override
          void tell(String what) {
            throw new IllegalStateException(what);
          }
        };
    run(0.25, failing, new Kernel("good", 10));
    assertEquals("0.25 good full\n0.25 good ended\n", events.toString());
    assertEquals("full", logged.getFirst());
  }

  /** Whoever fails when it is asked counts as asked, and the others are asked in their turn. */
  @Test
  void whoFailsToGiveBackMemoryDoesNotEndTheRescue() {
    Kernel failing =
        new Kernel("failing", 20) {
          @Override
          public void relieve() {
            super.relieve();
            throw new IllegalStateException("relieve");
          }
        };
    Kernel dumb =
        new Kernel("dumb", 30) {
          @Override
          public double growth() {
            throw new IllegalStateException("growth");
          }
        };
    run(2.25, failing, dumb, new Kernel("good", 10));
    assertEquals(
        """
        0.25 failing full
        0.25 dumb full
        0.25 good full
        0.25 failing ended
        1.25 failing gone
        2.25 good ended
        """,
        events.toString());
    assertEquals(List.of("growth", "relieve", "growth", "relieve", "growth"), logged);
  }

  /** To look at the heap takes some memory, too. What was kept for that is kept again later. */
  @Test
  void littleIsKeptForTheRescue() {
    Kernel kernel = new Kernel("one", 10);
    heap.full = false;
    run(0.25, kernel);
    heap.full = true;
    heap.exhausted = true;
    run(1, kernel);
    assertEquals("0.5 one full\n0.5 one ended\n", events.toString());
    assertFalse(heap.reserved);
    heap.full = false;
    heap.exhausted = false;
    run(0.25, kernel);
    assertTrue(heap.reserved);
    assertEquals("0.5 one full\n0.5 one ended\n1.5 one free\n", events.toString());
  }

  /** Nothing can be made any more: not even a sentence. */
  @Test
  void memoryOfWhichThereIsNoneForARescueIsTold() {
    Kernel failing =
        new Kernel("failing", 0) {
          @Override
          void tell(String what) {
            throw new OutOfMemoryError(what);
          }
        };
    Kernel other = new Kernel("other", 10);
    run(6, failing, other);
    assertEquals(
        """
        0.25 other full
        0.25 other ended
        1.25 other gone
        5.5 other exhausted
        """,
        events.toString());
  }

  private void fail(double seconds, MemoryUser... users) {
    clock.advanceTo(clock.now() + (long) (seconds * SECOND));
    rescue.failed(users);
  }

  /** It could not go on, and with it whoever else wants memory. */
  @Test
  void whoGotNoMemoryDoesNotWaitForTheNextLook() {
    Kernel kernel = new Kernel("one", 10);
    fail(0.125, kernel);
    assertEquals("0.125 one full\n0.125 one ended\n", events.toString());
    // What has been ended must have had some time to end.
    fail(0.0625, kernel);
    assertEquals("0.125 one full\n0.125 one ended\n", events.toString());
    fail(0.0625, kernel);
    assertEquals("0.125 one full\n0.125 one ended\n0.25 one gone\n", events.toString());
    fail(4.25, kernel);
    assertTrue(events.toString().endsWith("4.5 one exhausted\n"), events.toString());
    assertEquals(0, heap.collections, "all garbage has been collected for the one who got none");
  }

  /** One who wants a thousand times more than there is has got none, too. */
  @Test
  void nobodyIsEndedBecauseSomebodyWantedTooMuch() {
    heap.full = false;
    fail(1, new Kernel("one", 10));
    assertEquals("", events.toString());
  }

  @Test
  void littleIsKeptForWhoeverLooksAfterAFailure() {
    heap.reserved = true;
    heap.exhausted = true;
    fail(0.01, new Kernel("one", 10));
    assertEquals("0.01 one full\n0.01 one ended\n", events.toString());
    assertFalse(heap.reserved);
  }

  /** Where there is no memory even to look, from the first moment on, the process is to end. */
  @Test
  void memoryOfWhichThereIsNoneForALookIsTold() {
    Kernel blind =
        new Kernel("blind", 10) {
          @Override
          public void memoryScarce(boolean scarce) {
            throw new OutOfMemoryError();
          }
        };
    for (int i = 0; i < 24; i++) {
      fail(0.25, blind);
    }
    assertEquals("4.5 blind exhausted\n", events.toString());
  }
}
