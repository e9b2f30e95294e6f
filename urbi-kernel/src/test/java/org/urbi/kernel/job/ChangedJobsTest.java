package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.VirtualClock;

/** Who looks at the jobs that have changed misses none, however often he looks. */
class ChangedJobsTest {
  private final Loop loop = new Loop();
  private final TurnMeter meter = new TurnMeter(new VirtualClock(), 1);
  private final ChangedJobs changes = meter.changes();
  private final List<Job> changed = new ArrayList<>();
  private final List<Long> ended = new ArrayList<>();

  /** A job that was there before anybody looked. */
  private final Job old = loop.idle(null);

  private final Job other = loop.idle(null);

  private long begin() {
    return changes.takeAll(List.of(old, other));
  }

  private long take(long from) {
    changed.clear();
    ended.clear();
    return changes.take(from, changed, ended);
  }

  @Test
  void aJobThatHasManyTurnsIsNotedOnce() {
    long from = begin();
    for (int i = 0; i < 100_000; i++) {
      meter.turnOf(old);
      meter.turnOf(other);
    }
    assertTrue(changes.areKept(from));
    from = take(from);
    assertEquals(List.of(old, other), changed);
    take(from);
    assertEquals(List.of(), changed);
  }

  @Test
  void eachOneWhoLooksIsTold() {
    long one = begin();
    long two = begin();
    meter.turnOf(old);
    one = take(one);
    meter.turnOf(other);
    meter.turnOf(old);
    take(two);
    assertEquals(List.of(other, old), changed, "each where it has changed last");
    take(one);
    assertEquals(List.of(other, old), changed);
  }

  @Test
  void whatHasEndedIsToldAndNotKept() {
    long from = begin();
    meter.turnOf(old);
    meter.ended(old);
    take(from);
    assertEquals(List.of(), changed);
    assertEquals(List.of(old.number()), ended);
  }

  /** Very many jobs that nobody has seen take no room. */
  @Test
  void whatNobodyKnowsEndsUnnoted() {
    long from = begin();
    Job brief = loop.idle(null);
    meter.started(brief, null);
    meter.ended(brief);
    long next = take(from);
    assertEquals(List.of(), changed);
    assertEquals(List.of(), ended);
    Job seen = loop.idle(null);
    meter.started(seen, null);
    next = take(next);
    assertEquals(List.of(seen), changed);
    meter.ended(seen);
    take(next);
    assertEquals(List.of(seen.number()), ended);
  }

  @Test
  void whoLooksTooRarelyLearnsOfIt() {
    long from = begin();
    long often = from;
    for (int i = 0; i < 10_000; i++) {
      meter.turnOf(old);
      meter.turnOf(other);
      often = take(often);
    }
    assertFalse(changes.areKept(from));
    assertTrue(changes.areKept(often));
  }

  /** Whoever begins to look later is not taken for one who has looked before. */
  @Test
  void aNewTimeOfLookingKnowsNothingOfTheOneBefore() {
    Observation observation = new Observation(new VirtualClock());
    TurnMeter first = observation.begin();
    long from = first.changes().takeAll(List.of(old));
    first.turnOf(old);
    first.changes().take(from, changed, ended);
    observation.end();
    TurnMeter second = observation.begin();
    long next = second.changes().takeAll(List.of(old));
    second.turnOf(old);
    changed.clear();
    second.changes().take(next, changed, ended);
    assertEquals(List.of(old), changed);
  }
}
