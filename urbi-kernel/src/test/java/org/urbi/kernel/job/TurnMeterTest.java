package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.VirtualClock;

class TurnMeterTest {
  private final Loop loop = new Loop();
  private final VirtualClock clock = new VirtualClock();
  private final TurnMeter meter = new TurnMeter(clock);

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
    List<Turn> turns = meter.turns(0);
    assertEquals(1 << 13, turns.size());
    assertEquals(19_998, turns.getLast().begin());
    assertEquals(19_996, turns.get(turns.size() - 2).begin());
    assertEquals(List.of(), meter.turns(meter.next()));
  }
}
