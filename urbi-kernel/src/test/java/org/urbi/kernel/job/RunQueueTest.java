package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.object.UrbiObject;

/** Who runs next; and who waits when a round takes too long. A job takes as long as it is told. */
class RunQueueTest {
  private static final long MILLISECOND = 1_000_000;

  private final ManualClock clock = ManualClock.real();
  private final Loop loop = new Loop();
  private final Inbox inbox = new Inbox(Journal.NONE);
  private RunQueue queue = new RunQueue(clock, inbox, Journal.NONE);

  /** The lobbies, and the names of the jobs, which begin with that of their lobby. */
  private final Map<Character, UrbiObject> lobbies = new HashMap<>();

  private final Map<Job, String> names = new HashMap<>();

  private Job job(String name) {
    Job job = loop.idle(lobbies.computeIfAbsent(name.charAt(0), letter -> loop.object()));
    names.put(job, name);
    return job;
  }

  private void add(String... all) {
    for (String name : all) {
      queue.add(job(name));
    }
  }

  /** So many jobs of a lobby: a1, a2… */
  private void addMany(String lobby, int count) {
    for (int i = 1; i <= count; i++) {
      add(lobby + i);
    }
  }

  /** So many jobs of a lobby, with these numbers, are what a round runs. */
  private static String names(String lobby, int first, int last) {
    StringBuilder names = new StringBuilder();
    for (int i = first; i <= last; i++) {
      names.append(i == first ? "" : " ").append(lobby).append(i);
    }
    return names.toString();
  }

  /** Who has a turn in the next round, if each takes so long. */
  private String round(long milliseconds) {
    return round(milliseconds, false);
  }

  private String round(long milliseconds, boolean whole) {
    queue.beginRound(clock.now, whole);
    return rest(milliseconds);
  }

  private String rest(long milliseconds) {
    List<String> ran = new ArrayList<>();
    for (Job job = queue.next(); job != null; job = queue.next()) {
      ran.add(names.get(job));
      clock.now += milliseconds * MILLISECOND;
    }
    return String.join(" ", ran);
  }

  /** A crowd of one lobby, and one job of another, after the round that was cut short. */
  private void rush() {
    addMany("a", 30);
    add("b1");
    assertEquals(names("a", 1, 7), round(1));
  }

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
    queue.beginRound(0, false);
    assertEquals("a1", names.get(queue.next()));
    add("a3");
    assertEquals("a2", rest(0));
    assertEquals("a3", round(0));
  }

  @Test
  void whoIsStartedInARoundRunsNext() {
    add("a1", "a2");
    queue.beginRound(0, false);
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
    queue.beginRound(clock.now, false);
    assertEquals("a1", names.get(queue.next()));
    queue.addToRound(job("a3"));
    clock.now += 5 * MILLISECOND;
    assertNull(queue.next());
    assertEquals("a3 a2", round(0));
  }

  @Test
  void aRoundWithoutAnybodyIsOver() {
    queue.beginRound(0, false);
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
    queue = new RunQueue(ManualClock.simulated(), inbox, Journal.NONE);
    addMany("a", 30);
    assertEquals(names("a", 1, 30), round(100));
  }

  @Test
  void theLastRoundsAreNotCutShort() {
    addMany("a", 30);
    assertEquals(names("a", 1, 30), round(100, true));
    rush();
    assertEquals(names("a", 8, 30) + " b1", round(100, true));
  }

  /** The clock is looked at with the eighth job: that takes time as well. */
  @Test
  void aSliceIsOverWhenItsTimeIs() {
    addMany("a", 8);
    queue.beginRound(0, false);
    clock.now = 5 * MILLISECOND - 1;
    assertEquals(names("a", 1, 8), rest(0));
    addMany("b", 8);
    queue.beginRound(clock.now, false);
    clock.now += 5 * MILLISECOND;
    assertEquals(names("b", 1, 7), rest(0));
    assertFalse(queue.isEmpty());
    assertEquals("b8", round(0));
  }

  @Test
  void newsAreAReasonToLookAtTheClockAtOnce() {
    inbox.post(new Message.InputEnded(0));
    addMany("a", 4);
    queue.beginRound(0, false);
    clock.now = 4 * MILLISECOND;
    assertEquals("a1", rest(1));
    assertEquals("a2 a3 a4", round(0));
  }

  @Test
  void inARushWhoHasWaitedGoesFirst() {
    rush();
    // The crowd is still first, as it came first; its slice is not enough, so the round is over.
    assertEquals(names("a", 8, 14), round(1));
    assertEquals("b1 " + names("a", 15, 20), round(1));
    assertEquals(names("a", 21, 30), round(0));
    assertTrue(queue.isEmpty());
  }

  @Test
  void afterARushAllAreTogetherAgain() {
    rush();
    assertEquals(names("a", 8, 30) + " b1", round(0));
    addMany("b", 2);
    addMany("a", 2);
    add("b3");
    assertEquals("b1 b2 a1 a2 b3", round(0));
  }

  /** Those who can run again after the last round of a rush: the lobby that was first is first. */
  @Test
  void afterARushTheOrderIsThatOfTheLobbies() {
    rush();
    queue.beginRound(clock.now, false);
    for (int i = 0; i < 23; i++) {
      queue.next();
    }
    assertEquals("b1", names.get(queue.next()));
    add("c1", "b2", "a31");
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
    queue.beginRound(clock.now, false);
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
    assertEquals("a0 " + names("a", 8, 30) + " b0 b1", round(0));
  }

  @Test
  void inARushWhoIsStartedRunsNextIfItIsOfTheSameLobby() {
    rush();
    queue.beginRound(clock.now, false);
    assertEquals("a8", names.get(queue.next()));
    queue.addToRound(job("a0"));
    queue.addToRound(job("b0"));
    queue.addToRound(job("c1"));
    assertEquals("a0 " + names("a", 9, 30) + " b0 b1", rest(0));
    assertEquals("c1", round(0));
  }

  /** Three lobbies whose jobs take 4 ms each: none uses up its slice, but all have to wait. */
  @Test
  void aRoundOfManySlicesIsOverAfterTwo() {
    inbox.post(new Message.InputEnded(0));
    add("a1", "b1", "c1", "d1");
    queue.beginRound(clock.now, false);
    clock.now += 5 * MILLISECOND;
    assertNull(queue.next());
    assertEquals("a1 b1 c1", round(4));
    // Who was kept from its turn is the one that was cut short.
    add("a2");
    assertEquals("a2 d1", round(0));
  }

  @Test
  void twoSlicesAreOverWhenTheirTimeIs() {
    inbox.post(new Message.InputEnded(0));
    add("a1", "b1", "c1", "d1");
    queue.beginRound(clock.now, false);
    clock.now += 5 * MILLISECOND;
    assertNull(queue.next());
    long began = clock.now;
    queue.beginRound(began, false);
    assertEquals("a1", names.get(queue.next()));
    clock.now = began + 4 * MILLISECOND;
    assertEquals("b1", names.get(queue.next()));
    clock.now = began + 8 * MILLISECOND;
    assertEquals("c1", names.get(queue.next()));
    add("c2");
    clock.now = began + 10 * MILLISECOND - 1;
    assertEquals("d1", names.get(queue.next()));
    assertEquals("c2", round(0));
  }

  /** Both lobbies have been cut short once when the third one comes, so it is the last. */
  @Test
  void whoComesLaterHasNoCreditFromTheTimeBefore() {
    rush();
    assertEquals(names("a", 8, 14), round(1));
    addMany("b", 20);
    assertEquals("b1 " + names("b", 1, 6), round(1));
    add("c1");
    assertEquals(names("a", 15, 21), round(1));
    assertEquals(names("b", 7, 20) + " c1 " + names("a", 22, 30), round(0));
  }

  @Test
  void aRecordingSaysWhereARoundIsCutShort() {
    List<String> asked = new ArrayList<>();
    queue =
        new RunQueue(
            clock,
            inbox,
            new Journal() {
              @Override
              public boolean countsChecks() {
                return true;
              }

              @Override
              public boolean cutsRound(int jobs, boolean wanted) {
                asked.add(jobs + " " + wanted);
                return jobs == 3;
              }
            });
    addMany("a", 4);
    assertEquals("a1 a2", round(0));
    assertEquals(List.of("1 false", "2 false", "3 false"), asked);
    assertEquals("a3 a4", round(0));
  }
}
