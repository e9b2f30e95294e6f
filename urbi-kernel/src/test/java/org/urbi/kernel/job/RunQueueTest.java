package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;

/** Who runs next; and who waits when a round takes too long. A job takes as long as it is told. */
class RunQueueTest extends RunQueueFixture {
  @Test
  void everybodyHasATurnInTheOrderInWhichTheyCame() {
    assertTrue(queue.isEmpty());
    add("a1", "b1", "a2");
    queue.addFirst(job("c1"));
    assertFalse(queue.isEmpty());
    assertEquals("c1 a1 b1 a2", round(0));
    assertTrue(queue.isEmpty());
    assertEquals("", round(0));
  }

  @Test
  void whoCanRunAgainWaitsForTheNextRound() {
    add("a1", "a2");
    queue.beginRound(clock.now());
    assertEquals("a1", names.get(queue.next()));
    add("a3");
    assertEquals("a2", rest(0));
    assertEquals("a3", round(0));
  }

  @Test
  void whoIsStartedInARoundRunsNext() {
    add("a1", "a2");
    queue.beginRound(clock.now());
    queue.next();
    queue.addToRound(job("b1"));
    queue.addToRound(job("c1"));
    assertEquals("c1 b1 a2", rest(0));
    assertTrue(queue.isEmpty());
  }

  /** What follows in the lobby may rely on it: in {@code var x = 1, x} the job that makes x. */
  @Test
  void whoIsStartedInARoundThatIsCutShortRunsFirstInTheNext() {
    inbox.post(new Message.InputEnded(0));
    add("a1", "a2");
    queue.beginRound(clock.now());
    assertEquals("a1", names.get(queue.next()));
    queue.addToRound(job("a3"));
    clock.now += 5 * MILLISECOND;
    assertNull(queue.next());
    assertEquals("a3 a2", round(0));
  }

  @Test
  void aRoundWithoutAnybodyIsOver() {
    queue.beginRound(clock.now());
    clock.now = Loop.SECOND;
    inbox.post(new Message.InputEnded(0));
    assertNull(queue.next());
    assertEquals("", round(0));
  }

  @Test
  void somebodyIsLookedFor() {
    add("a1", "b1");
    Job known = job("c1");
    assertFalse(queue.hasAny(job -> job == known));
    queue.add(known);
    assertTrue(queue.hasAny(job -> job == known));
  }

  @Test
  void simulatedRoundsAreNeverCutShort() {
    queue = new RunQueue(ManualClock.simulated(), () -> worked, timers, inbox, Journal.NONE);
    addMany("a", 30);
    assertEquals(names("a", 1, 30), round(100));
  }

  @Test
  void theLastRoundsAreNotCutShort() {
    addMany("a", 30);
    assertEquals(names("a", 1, 30), round(100, true));
    rush();
    assertEquals("b1 " + names("a", 8, 30), round(100, true));
  }

  /** The clock is looked at with the eighth job: that takes time as well. */
  @Test
  void aSliceIsOverWhenItsTimeIs() {
    addMany("a", 8);
    queue.beginRound(clock.now());
    clock.now = 5 * MILLISECOND - 1;
    assertEquals(names("a", 1, 8), rest(0));
    // Those were slow, so these are looked at, and then no more.
    addMany("c", 8);
    assertEquals(names("c", 1, 8), round(0));
    addMany("b", 8);
    queue.beginRound(clock.now());
    clock.now += 5 * MILLISECOND;
    assertEquals(names("b", 1, 7), rest(0));
    assertFalse(queue.isEmpty());
    assertEquals("b8", round(0));
  }

  @Test
  void newsAreAReasonToLookAtTheClockAtOnce() {
    inbox.post(new Message.InputEnded(0));
    addMany("a", 4);
    queue.beginRound(clock.now());
    clock.now = 4 * MILLISECOND;
    assertEquals("a1", rest(1));
    assertEquals("a2 a3 a4", round(0));
  }

  /** The jobs of one lobby take long, so one after the other is a reason to look at the clock. */
  @Test
  void slowJobsAreAReasonToLookAtTheClockEachTime() {
    addMany("a", 16);
    queue.beginRound(clock.now());
    for (int i = 0; i < 7; i++) {
      queue.next();
    }
    clock.now += MILLISECOND;
    assertEquals("a8 a9", rest(2));
    assertEquals(names("a", 10, 16), round(0));
  }

  /** Whom a timer wakes waits for the end of the round. */
  @Test
  void aTimerThatIsDueMakesARoundShort() {
    add("a1", "b1", "c1", "d1", "e1");
    timers.add(3 * MILLISECOND, () -> add("x1"));
    assertEquals("a1 b1 c1", round(1));
    timers.fire(clock.now);
    assertEquals("d1 e1 x1", round(1));
  }

  @Test
  void inARushWhoHasWaitedGoesFirst() {
    rush();
    assertEquals("b1 " + names("a", 8, 11), round(1));
    add("b2");
    assertEquals("b2 " + names("a", 12, 15), round(1));
    assertEquals(names("a", 16, 30), round(0));
    assertTrue(queue.isEmpty());
  }

  @Test
  void afterARushAllAreTogetherAgain() {
    rush();
    assertEquals("b1 " + names("a", 8, 30), round(0));
    addMany("b", 2);
    addMany("a", 2);
    add("b3");
    assertEquals("b1 b2 a1 a2 b3", round(0));
  }

  /**
   * The lobbies stay together, each job keeps its turn, and later they have queues of their own.
   */
  @Test
  void aRushWithoutMemoryForQueuesLosesNobody() {
    var full = new AtomicBoolean(true);
    queue =
        new RunQueue(clock, () -> worked, timers, inbox, Journal.NONE) {
          @Override
          Share shareOf(Budget budget) {
            if (full.get()) {
              throw new OutOfMemoryError("a test has none");
            }
            return super.shareOf(budget);
          }
        };
    addMany("a", 30);
    add("b1");
    List<String> ran = new ArrayList<>();
    assertThrows(OutOfMemoryError.class, () -> turns(1, ran));
    assertEquals(names("a", 1, 7), String.join(" ", ran));
    add("a31");
    assertEquals("", round(1));
    assertThrows(OutOfMemoryError.class, () -> turns(1, ran));
    assertEquals(names("a", 1, 12), String.join(" ", ran));
    full.set(false);
    assertEquals(names("a", 13, 17), round(1));
    assertEquals("b1 " + names("a", 18, 31), round(0));
    assertTrue(queue.isEmpty());
  }

  /** Those who can run again after the last round of a rush: the lobby that was first is first. */
  @Test
  void afterARushTheOrderIsThatOfTheLobbies() {
    rush();
    queue.beginRound(clock.now());
    assertEquals("b1", names.get(queue.next()));
    for (int i = 0; i < 23; i++) {
      queue.next();
    }
    add("c1", "b2", "a31");
    clock.now += MILLISECOND;
    assertNull(queue.next());
    assertEquals("a31 b2 c1", round(0));
  }

  @Test
  void inARushThereIsSomebodyOrNot() {
    rush();
    assertFalse(queue.isEmpty());
    Job known = job("b2");
    Job first = job("c1");
    assertFalse(queue.hasAny(job -> job == known));
    queue.add(known);
    queue.addFirst(first);
    assertTrue(queue.hasAny(job -> job == known));
    assertTrue(queue.hasAny(job -> job == first));
    queue.beginRound(clock.now());
    for (int i = 0; i < 26; i++) {
      assertFalse(queue.isEmpty());
      queue.next();
    }
    assertTrue(queue.isEmpty());
  }

  @Test
  void inARushWhoIsFirstIsSoAmongThoseOfItsLobby() {
    rush();
    queue.addFirst(job("b0"));
    queue.addFirst(job("a0"));
    assertEquals("b0 b1 a0 " + names("a", 8, 30), round(0));
  }

  @Test
  void inARushWhoIsStartedRunsNextIfItIsOfTheSameLobby() {
    rush();
    queue.beginRound(clock.now());
    assertEquals("b1", names.get(queue.next()));
    queue.addToRound(job("a0"));
    queue.addToRound(job("b0"));
    queue.addToRound(job("c1"));
    assertEquals("b0 " + names("a", 8, 30) + " a0", rest(0));
    assertEquals("c1", round(0));
  }

  /** Two jobs emit an event, and the reactions are jobs of another lobby. */
  @Test
  void inARushReactionsOfAnotherLobbyKeepTheirOrder() {
    rush();
    add("b2");
    queue.beginRound(clock.now());
    assertEquals("b1", names.get(queue.next()));
    queue.addToRound(job("a31"));
    queue.addToRound(job("c1"));
    assertEquals("b2", names.get(queue.next()));
    queue.addToRound(job("a32"));
    queue.addToRound(job("c2"));
    assertEquals(names("a", 8, 32), rest(0));
    assertEquals("c1 c2", round(0));
  }

  /** Four lobbies whose jobs take 4 ms each: two in a round, and the others in the next one. */
  @Test
  void aRoundOfManyLobbiesIsOverAfterASlice() {
    add("a1", "b1", "c1", "d1");
    assertEquals("a1 b1", round(4));
    // The round was cut short by b, so it is the last one from now on.
    add("b2", "a2");
    assertEquals("c1 d1", round(4));
    assertEquals("a2 b2", round(0));
  }

  @Test
  void whoNeedsLittleGoesOnInTheSameRound() {
    rush();
    Job late = job("c1");
    queue.add(late);
    queue.beginRound(clock.now());
    List<String> ran = new ArrayList<>();
    for (Job job = queue.next(); job != null; job = queue.next()) {
      ran.add(names.get(job));
      clock.now += job == late ? MILLISECOND / 10 : 0;
      if (job == late) {
        queue.add(late);
      }
    }
    assertEquals("b1 c1 c1 c1 " + names("a", 8, 30), String.join(" ", ran));
  }

  @Test
  void somebodyRunsInEveryRound() {
    add("a1", "b1");
    queue.beginRound(clock.now());
    clock.now += 100 * MILLISECOND;
    assertEquals("a1", rest(0));
    queue.beginRound(clock.now());
    clock.now += 100 * MILLISECOND;
    assertEquals("b1", rest(0));
  }

  @Test
  void aRecordingSaysWhereARoundIsCutShort() {
    List<String> asked = new ArrayList<>();
    queue =
        new RunQueue(
            clock,
            () -> worked,
            timers,
            inbox,
            new Journal() {
              @Override
              public boolean countsChecks() {
                return true;
              }

              @Override
              public int cutsRound(int jobs, int wanted) {
                asked.add(jobs + " " + wanted);
                return jobs == 3 ? 0 : NOBODY;
              }
            });
    addMany("a", 4);
    assertEquals("a1 a2", round(0));
    assertEquals(List.of("1 -1", "2 -1", "3 -1"), asked);
    assertEquals("a3 a4", round(0));
  }

  @Test
  void jobThatGoesOnRunningLeavesTheQueue() {
    addMany("a", 30);
    add("b1");
    assertFalse(round(20).contains("b1"));
    // Now each lobby has a queue of its own.
    Job leaving = job("b2");
    queue.add(leaving);
    queue.remove(leaving);
    queue.remove(leaving);
    assertFalse(queue.hasAny(job -> job == leaving));
    while (!queue.isEmpty()) {
      assertFalse(round(1).contains("b2"));
    }
    queue.add(leaving);
    assertEquals("b2", round(1));
    assertTrue(queue.isEmpty());
  }

  /** Its objects would stay in memory for as long as nobody else does anything. */
  @Test
  void lobbyThatHasGoneIsNotRemembered() {
    WeakReference<Budget> gone = whoseJobHasRun();
    lobbies.clear();
    names.clear();
    System.gc();
    assertNull(gone.get());
  }

  private WeakReference<Budget> whoseJobHasRun() {
    Job only = job("a1");
    queue.add(only);
    assertEquals("a1", round(1));
    loop.scheduler.rootScope().remove(only);
    return new WeakReference<>(only.budget());
  }
}
