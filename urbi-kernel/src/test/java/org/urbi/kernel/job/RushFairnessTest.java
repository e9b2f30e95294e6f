package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Who has how many turns while a round cannot serve all: who needs little does not wait. */
class RushFairnessTest extends RunQueueFixture {
  /** The others always want to run, and take 5 ms; x needs little, and comes and goes. */
  @Test
  void whoNeedsLittleAndComesBackGoesFirst() {
    add("a1", "b1", "c1", "x1", "d1");
    int firsts = 0;
    for (int i = 0; i < 50; i++) {
      queue.beginRound(clock.now());
      Job first = queue.next();
      Job away = null;
      for (Job job = first; job != null; job = queue.next()) {
        if (names.get(job).equals("x1")) {
          firsts += job == first ? 1 : 0;
          away = job;
        } else {
          clock.now += 5 * MILLISECOND;
          queue.add(job);
        }
      }
      if (away != null) {
        assertEquals(1, countOfRound(), "a round without x");
        queue.add(away);
      }
    }
    assertTrue(firsts >= 20, "first: " + firsts);
  }

  private int countOfRound() {
    queue.beginRound(clock.now());
    int count = 0;
    for (Job job = queue.next(); job != null; job = queue.next()) {
      count++;
      clock.now += 5 * MILLISECOND;
      queue.add(job);
    }
    return count;
  }

  /** A hundred lobbies always want to run for a millisecond, and half of them came later. */
  @Test
  void whoNeedsTheSameHasEquallyManyTurns() {
    Map<String, Integer> turns = new HashMap<>();
    addLobbies('\u4e00', 50);
    for (int i = 0; i < 12_000; i++) {
      if (i == 100) {
        addLobbies('\u5e00', 50);
      }
      queue.beginRound(clock.now());
      for (Job job = queue.next(); job != null; job = queue.next()) {
        if (i >= 1000) {
          turns.merge(names.get(job), 1, Integer::sum);
        }
        clock.now += MILLISECOND;
        queue.add(job);
      }
    }
    assertEquals(100, turns.size());
    int most = Collections.max(turns.values());
    int fewest = Collections.min(turns.values());
    assertTrue(most <= 2 * fewest, "from " + fewest + " to " + most);
  }

  @Test
  void whoNeedsLittleIsNotToBlame() {
    assertSoonRunsAgain(100, 5 * MILLISECOND, LITTLE, 200);
  }

  /** Now and then the machine does something else while it is the turn of x. */
  @Test
  void whoDoesNotGetTheProcessorIsNotToBlame() {
    worked = 0;
    assertSoonRunsAgain(100, 5 * MILLISECOND, 20 * MILLISECOND, 500);
  }

  /** Each of the others has a turn in every 100th round. */
  @Test
  void howManyOthersWaitDoesNotMatterToWhoNeedsLittle() {
    assertSoonRunsAgain(500, MILLISECOND * 6 / 5, LITTLE, 500);
  }

  /**
   * So many lobbies always want to run for that long, and x needs little again and again.
   *
   * @param fifth how long it takes in each fifth round, even if it does not have the processor
   * @param known from that round on it never waits long
   */
  private void assertSoonRunsAgain(int others, long each, long fifth, int known) {
    add("x1");
    addLobbies('\u4e00', others);
    int before = known;
    int longest = 0;
    for (int i = 0; i < 2000; i++) {
      queue.beginRound(clock.now());
      for (Job job = queue.next(); job != null; job = queue.next()) {
        boolean little = names.get(job).equals("x1");
        if (little && i > known) {
          longest = Math.max(longest, i - before);
          before = i;
        }
        long work = little ? LITTLE : each;
        worked += worked == HoldWatchdog.UNKNOWN ? 0 : work;
        clock.now += little && i % 5 == 0 ? fifth : work;
        queue.add(job);
      }
    }
    assertTrue(before > 1990, "the last round with x: " + before);
    assertTrue(longest <= 3, "rounds without x: " + longest);
  }

  /** The kernel has taken messages for long before the round begins. */
  @Test
  void timeBeforeARoundIsNobodysFault() {
    add("a1", "x1");
    for (int i = 0; i < 200; i++) {
      clock.now += 5 * MILLISECOND;
      queue.beginRound(clock.now());
      int turns = 0;
      for (Job job = queue.next(); job != null; job = queue.next()) {
        turns++;
        clock.now += names.get(job).equals("a1") ? 3 * MILLISECOND : 0;
        queue.add(job);
      }
      assertEquals(2, turns);
    }
  }

  private void addLobbies(char first, int count) {
    for (int i = 0; i < count; i++) {
      add(Character.toString(first + i));
    }
  }

  /** It counts as one that was to blame once, or who must wait would come back as another. */
  @Test
  void whoIsNewHasNoCredit() {
    add("a1", "b1");
    assertEquals("a1", round(5));
    add("a2");
    assertEquals("b1", round(5));
    add("b2");
    assertEquals("a2", round(5));
    add("b3", "c1");
    assertEquals("b2", round(5));
    add("a3", "d1", "e1");
    assertEquals("c1 b3 a3 d1 e1", round(0));
  }
}
