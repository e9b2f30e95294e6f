package org.urbi.kernel.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

/** How the heap of this process is measured. */
class HeapUsageTest {
  private final HeapUsage heap = new HeapUsage();

  /** Who ends a process without memory must not need any for the time that this takes. */
  @Test
  void toMeasureTakesNoMemory() {
    heap.prepare();
    measure();
    var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();
    long asking = threads.getCurrentThreadAllocatedBytes() - before;
    before = threads.getCurrentThreadAllocatedBytes();
    measure();
    assertEquals(asking, threads.getCurrentThreadAllocatedBytes() - before);
  }

  private void measure() {
    for (int i = 0; i < 100; i++) {
      assertTrue(heap.collecting() >= 0 && heap.collections() >= 0 && !heap.isExhausted());
    }
  }
}
