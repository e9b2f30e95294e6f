package org.urbi.server.cli;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** How full the heap is. */
final class HeapUsage {
  /** Below, it is not worth a closer look. */
  private static final double SCARCE = 0.6;

  /** What is left of the old objects' room after a collection, when it is nearly nothing. */
  private static final double FULL = 0.92;

  /** The part of the time that may be spent on collecting garbage. */
  private static final double MAX_COLLECTING = 0.8;

  /** How long that is watched, in nanoseconds. */
  private static final long WINDOW = 2_000_000_000;

  private static final long MILLISECOND = 1_000_000;

  /** Where old objects are; looked for when it matters, since that takes long. */
  private @Nullable MemoryPoolMXBean old;

  private List<GarbageCollectorMXBean> collectors = List.of();
  private long windowBegan;
  private long collectedBefore;
  private boolean collecting;

  /** Whether so much is used that it may become tight soon. */
  boolean isScarce() {
    Runtime runtime = Runtime.getRuntime();
    double used = (double) runtime.totalMemory() - runtime.freeMemory();
    return used >= SCARCE * runtime.maxMemory();
  }

  /**
   * Whether collecting garbage leaves nearly no room, or takes nearly all of the time; to be asked
   * several times a second while memory is scarce.
   *
   * @param now the time in nanoseconds
   */
  boolean isTight(long now) {
    MemoryPoolMXBean known = old;
    if (known == null) {
      known =
          ManagementFactory.getMemoryPoolMXBeans().stream()
              .filter(pool -> pool.getType() == MemoryType.HEAP)
              .max(Comparator.comparingLong(pool -> pool.getUsage().getMax()))
              .orElseThrow();
      old = known;
      // Those that work beside the program keep nobody waiting.
      collectors =
          ManagementFactory.getGarbageCollectorMXBeans().stream()
              .filter(bean -> !bean.getName().matches(".*(Cycles|Concurrent).*"))
              .toList();
    }
    MemoryUsage left = known.getCollectionUsage();
    return left != null && left.getMax() > 0 && left.getUsed() > FULL * left.getMax()
        || isCollecting(now);
  }

  private boolean isCollecting(long now) {
    long collected = 0;
    for (GarbageCollectorMXBean each : collectors) {
      collected += each.getCollectionTime();
    }
    if (windowBegan == 0 || now - windowBegan > WINDOW) {
      double spent = (collected - collectedBefore) * (double) MILLISECOND;
      collecting = windowBegan != 0 && spent > MAX_COLLECTING * (now - windowBegan);
      windowBegan = now;
      collectedBefore = collected;
    }
    return collecting;
  }

  /** Memory is not scarce any more. */
  void forget() {
    windowBegan = 0;
    collecting = false;
  }
}
