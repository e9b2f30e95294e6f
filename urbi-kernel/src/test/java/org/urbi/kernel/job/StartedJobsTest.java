package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.UrbiObject;

/** When those run that a job has started in its turn. */
class StartedJobsTest {
  private static final long TOO_LONG = 5_000_000;
  private static final long TURN = 400_000;

  private final ManualClock clock = ManualClock.real();
  private final Loop loop = new Loop();
  private final RunQueue queue =
      new RunQueue(
          clock,
          () -> HoldWatchdog.UNKNOWN,
          new Timers(Budget::new),
          new Inbox(Journal.NONE),
          Journal.NONE);
  private final StartedJobs started = new StartedJobs(queue);
  private final Map<Character, UrbiObject> lobbies = new HashMap<>();
  private final Map<Job, String> names = new HashMap<>();

  private Job job(String name) {
    Job job = loop.idle(lobbies.computeIfAbsent(name.charAt(0), letter -> loop.lobby()));
    names.put(job, name);
    return job;
  }

  private Job next() {
    Job job = queue.next();
    if (job == null) {
      throw new AssertionError("nobody is next");
    }
    return job;
  }

  private void starts(Job parent, String... children) {
    for (String child : children) {
      started.add(job(child), parent);
    }
    started.joinRound();
  }

  private void beginRound() {
    started.beginRound();
    queue.beginRound(clock.now());
  }

  private String rest() {
    List<String> ran = new ArrayList<>();
    for (Job job = queue.next(); job != null; job = queue.next()) {
      ran.add(names.get(job));
    }
    return String.join(" ", ran);
  }

  @Test
  void theyRunRightBehindItInTheirOrder() {
    queue.add(job("a1"));
    queue.add(job("a2"));
    beginRound();
    starts(next(), "b1", "b2", "a3", "b3");
    assertEquals("b1 b2 a3 b3 a2", rest());
  }

  /** A component emits an event three times in a turn: the reactions are of another lobby. */
  @Test
  void inARushThoseOfAnotherLobbyKeepTheirOrder() {
    queue.add(job("a1"));
    queue.add(job("b1"));
    queue.add(job("a2"));
    beginRound();
    next();
    clock.now += TOO_LONG;
    assertEquals("", rest());
    beginRound();
    starts(next(), "a3", "b3", "c1", "a4", "b4", "c2", "a5", "b5", "c3");
    assertEquals("b3 b4 b5 a2 a3 a4 a5", rest());
    beginRound();
    assertEquals("c1 c2 c3", rest());
  }

  /** Who has waited since a rush must not be overtaken by what is started when it is over. */
  @Test
  void whoWaitsElsewhereAtTheEndOfARushIsNotOvertaken() {
    queue.add(job("a1"));
    queue.add(job("c1"));
    queue.add(job("a2"));
    queue.add(job("b1"));
    beginRound();
    next();
    clock.now += TOO_LONG;
    assertEquals("", rest());
    beginRound();
    assertEquals("c1", names.get(next()));
    assertEquals("b1", names.get(next()));
    Job second = next();
    assertEquals("a2", names.get(second));
    starts(second, "b2");
    queue.add(job("a3"));
    clock.now += TURN;
    assertEquals("", rest());
    List<String> ran = new ArrayList<>();
    while (ran.size() < 3) {
      beginRound();
      for (Job job = queue.next(); job != null; job = queue.next()) {
        ran.add(names.get(job));
        if (ran.getLast().equals("a3")) {
          starts(job, "b3");
        }
      }
    }
    assertTrue(ran.indexOf("b2") < ran.indexOf("b3"), ran::toString);
  }
}
