package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.VirtualClock;

class TurnMeterTest {
  private final Loop loop = new Loop();
  private final VirtualClock clock = new VirtualClock();
  private final TurnMeter meter = new TurnMeter(clock, 1);

  private void turn(Job job) {
    meter.turnOf(job);
    clock.advanceTo(clock.now() + 1);
  }

  /**
   * A job that has been taken from its queue would be lost if there were no memory for its turn.
   */
  @Test
  void whatIsKeptOfTurnsTakesNoMemory() {
    Job one = loop.idle(null);
    Job other = loop.idle(null);
    meter.beginTrace(one);
    meter.beginTrace(other);
    var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    for (int i = 0; i < 1000; i++) {
      turn(one);
      turn(other);
    }
    long before = threads.getCurrentThreadAllocatedBytes();
    for (int i = 0; i < 1000; i++) {
      turn(one);
      turn(other);
    }
    long allocated = threads.getCurrentThreadAllocatedBytes() - before;
    meter.turnOf(null);
    assertEquals(0, allocated);
    assertEquals(4000, meter.next());
    assertEquals(2000, meter.ran(one));
  }

  /** Whoever looks too rarely gets the latest turns, in order. */
  @Test
  void onlyTheLatestTurnsAreKept() {
    Job one = loop.idle(null);
    Job other = loop.idle(null);
    meter.beginTrace(one);
    for (int i = 0; i < 10_000; i++) {
      turn(one);
      turn(other);
    }
    List<Turn> turns = meter.turns(0, meter.next(), Set.of(one.number()));
    assertEquals(1 << 13, turns.size());
    assertEquals(19_998, turns.getLast().begin());
    assertEquals(19_996, turns.get(turns.size() - 2).begin());
    assertEquals(List.of(), meter.turns(meter.next(), meter.next(), Set.of(one.number())));
    assertEquals(turns.getFirst().begin(), meter.lostUntil(0), "what was before is lost");
    assertEquals(0, meter.lostUntil(meter.next() - (1 << 13)), "nothing after that");
  }

  /** Else nobody would see what the others do while two never wait. */
  @Test
  void jobsThatNeverWaitLeaveRoomForOthers() {
    Job one = loop.idle(null);
    Job other = loop.idle(null);
    Job third = loop.idle(null);
    List.of(one, other, third).forEach(meter::beginTrace);
    for (int i = 0; i < 100_000; i++) {
      meter.woken(one, one);
      turn(one);
      meter.woken(other, other);
      turn(other);
      if (i % 1000 == 0) {
        turn(third);
      }
    }
    meter.turnOf(null);
    assertEquals(0, meter.lostUntil(0));
    List<Turn> turns =
        meter.turns(0, meter.next(), Set.of(one.number(), other.number(), third.number()));
    assertEquals(100, turns.stream().filter(turn -> turn.job() == third.number()).count());
    Turn latest = turns.stream().filter(turn -> turn.job() == one.number()).toList().getLast();
    assertEquals(clock.now() - 1, latest.end(), "it goes on until the last turn of the other one");
    turn(one);
    meter.turnOf(null);
    assertEquals(1, meter.turns(meter.next() - 1, meter.next(), Set.of(one.number())).size());
    assertEquals(
        clock.now() - 1,
        meter.turns(meter.next() - 1, meter.next(), Set.of(one.number())).getFirst().begin());
  }

  /** Thousands at once would keep the kernel. */
  @Test
  void turnsAreHadInParts() {
    Job one = loop.idle(null);
    Job other = loop.idle(null);
    meter.beginTrace(one);
    for (int i = 0; i < 10; i++) {
      turn(one);
      turn(other);
    }
    Set<Long> wanted = Set.of(one.number());
    assertEquals(4, meter.turns(0, 4, wanted).size());
    assertEquals(6, meter.turns(4, meter.next(), wanted).size());
  }

  /** Others may have traced a job before, and from time to time: that is nothing to build on. */
  @Test
  void turnsThatOthersWantAreLeftOut() {
    Job one = loop.idle(null);
    Job other = loop.idle(null);
    meter.beginTrace(one);
    meter.beginTrace(other);
    turn(one);
    turn(other);
    meter.turnOf(null);
    List<Turn> turns = meter.turns(0, meter.next(), Set.of(other.number()));
    assertEquals(List.of(other.number()), turns.stream().map(Turn::job).toList());
  }

  /** The first turns of a new job are kept for all, from its start on, until there were many. */
  @Test
  void firstTurnsAreKnownFromTheStartOn() {
    Job known = loop.idle(null);
    meter.beginTrace(known);
    clock.advanceTo(10);
    Job born = loop.idle(null);
    meter.started(born, known);
    clock.advanceTo(20);
    assertEquals(10, meter.firstTurnsSince(born));
    assertEquals(20, meter.firstTurnsSince(known));
    for (int i = 0; i < 64; i++) {
      turn(born);
      turn(known);
    }
    assertEquals(clock.now(), meter.firstTurnsSince(born));
    meter.turnOf(null);
    assertEquals(64, meter.turns(0, meter.next(), Set.of()).size());
  }
}
