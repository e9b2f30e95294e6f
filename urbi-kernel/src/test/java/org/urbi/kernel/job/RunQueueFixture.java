package org.urbi.kernel.job;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.UrbiObject;

/** A queue of jobs that take as long as they are told. */
abstract class RunQueueFixture {
  static final long MILLISECOND = 1_000_000;
  static final long LITTLE = MILLISECOND / 10;

  final ManualClock clock = ManualClock.real();

  /** The processor time. */
  long worked = HoldWatchdog.UNKNOWN;

  final Loop loop = new Loop();
  final Inbox inbox = new Inbox(Journal.NONE);
  final Timers timers = new Timers(Budget::new);
  RunQueue queue = new RunQueue(clock, () -> worked, timers, inbox, Journal.NONE);

  /** The lobbies, and the names of the jobs, which begin with that of their lobby. */
  final Map<Character, UrbiObject> lobbies = new HashMap<>();

  final Map<Job, String> names = new HashMap<>();

  Job job(String name) {
    Job job = loop.idle(lobbies.computeIfAbsent(name.charAt(0), letter -> loop.lobby()));
    names.put(job, name);
    return job;
  }

  void add(String... all) {
    for (String name : all) {
      queue.add(job(name));
    }
  }

  /** So many jobs of a lobby: a1, a2… */
  void addMany(String lobby, int count) {
    add(names(lobby, 1, count).split(" "));
  }

  /** So many jobs of a lobby, with these numbers, are what a round runs. */
  static String names(String lobby, int first, int last) {
    return IntStream.rangeClosed(first, last).mapToObj(i -> lobby + i).collect(joining(" "));
  }

  /** Who has a turn in the next round, if each takes so long. */
  String round(long milliseconds) {
    return round(milliseconds, false);
  }

  String round(long milliseconds, boolean whole) {
    if (whole) {
      queue.beginWholeRound();
    } else {
      queue.beginRound(clock.now());
    }
    return rest(milliseconds);
  }

  String rest(long milliseconds) {
    List<String> ran = new ArrayList<>();
    turnsLeft(milliseconds, ran);
    return String.join(" ", ran);
  }

  void turns(long milliseconds, List<String> ran) {
    queue.beginRound(clock.now());
    turnsLeft(milliseconds, ran);
  }

  void turnsLeft(long milliseconds, List<String> ran) {
    for (Job job = queue.next(); job != null; job = queue.next()) {
      ran.add(names.get(job));
      clock.now += milliseconds * MILLISECOND;
    }
  }

  /** A crowd of one lobby, and one job of another, after the round that was cut short. */
  void rush() {
    addMany("a", 30);
    add("b1");
    assertEquals(names("a", 1, 7), round(1));
  }
}
