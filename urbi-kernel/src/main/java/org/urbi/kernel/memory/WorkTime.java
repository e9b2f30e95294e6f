package org.urbi.kernel.memory;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.outside.Heap;
import org.urbi.kernel.time.Clock;

/**
 * For how long this process has worked: time in which others had the processors, or in which
 * garbage was collected, does not count, except for a part of it, so that it goes on in a process
 * that can do nothing.
 */
final class WorkTime implements LongSupplier {
  /** A process that gets no processor has so many times that by the clock. */
  private static final int LONGEST_WAIT = 5;

  /** A process that only collects garbage has so many times that by the clock. */
  private static final int LONGEST_COLLECTION = 3;

  private final Clock clock;
  private final Heap heap;
  private @Nullable OperatingSystemMXBean system;
  private long passed;
  private long processor;
  private long collecting;
  private long worked;

  /**
   * @param clock real time
   */
  WorkTime(Clock clock, Heap heap) {
    this.clock = clock;
    this.heap = heap;
  }

  /** Begins to measure; before, time is that of the clock. */
  void prepare() {
    getAsLong();
    OperatingSystemMXBean found = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    processor = found.getProcessCpuTime();
    collecting = heap.collecting();
    system = found;
  }

  /** In nanoseconds, from some beginning. */
  @Override
  public long getAsLong() {
    long now = clock.now();
    long since = now - passed;
    passed = now;
    OperatingSystemMXBean known = system;
    if (known == null) {
      worked += since;
    } else {
      long had = known.getProcessCpuTime();
      long collected = heap.collecting();
      long stood = Math.clamp(collected - collecting, 0, Math.max(since, 0));
      long free = Math.max(since - stood, 0);
      worked += Math.clamp(had - processor - stood, free / LONGEST_WAIT, free);
      worked += stood / LONGEST_COLLECTION;
      processor = had;
      collecting = collected;
    }
    return worked;
  }
}
