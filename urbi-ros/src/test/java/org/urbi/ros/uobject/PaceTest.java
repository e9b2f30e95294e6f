package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.urbi.ros.graph.RosException;

class PaceTest {
  @Test
  void withoutALimitAllIsDone() {
    AtomicInteger done = new AtomicInteger();
    Pace pace = new Pace(0, done::incrementAndGet);
    for (int i = 0; i < 1000; i++) {
      pace.want();
    }
    assertEquals(1000, done.get());
  }

  @Test
  void whatIsTooEarlyIsDoneOnceLater() throws InterruptedException {
    Semaphore done = new Semaphore(0);
    Pace pace = new Pace(5, done::release);
    pace.want();
    assertEquals(1, done.drainPermits());
    for (int i = 0; i < 1000; i++) {
      pace.want();
    }
    done.acquire();
    assertEquals(0, done.availablePermits());
  }

  @Test
  void aRateIsANumber() {
    assertThrows(RosException.class, () -> new Pace(-1, () -> {}));
    assertThrows(RosException.class, () -> new Pace(Double.NaN, () -> {}));
  }
}
