package org.urbi.kernel.memory;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.time.Clock;

/**
 * For how long this process has worked: time in which others had the processors does not count,
 * except for a part of it, so that it goes on in a process that gets none.
 */
final class WorkTime implements LongSupplier {
  /** A process that gets no processor has so many times that by the clock. */
  private static final int LONGEST_WAIT = 5;

  private final Clock clock;
  private @Nullable OperatingSystemMXBean system;
  private long passed;
  private long processor;
  private long worked;

  /**
   * @param clock real time
   */
  WorkTime(Clock clock) {
    this.clock = clock;
  }

  /** Begins to measure; before, time is that of the clock. */
  void prepare() {
    getAsLong();
    OperatingSystemMXBean found = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    processor = found.getProcessCpuTime();
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
      worked += Math.clamp(had - processor, since / LONGEST_WAIT, Math.max(since, 0));
      processor = had;
    }
    return worked;
  }
}
