package org.urbi.server.cli;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.Comparator;

/** How full the heap is. */
final class Memory {
  /** Below, it is not worth a closer look. */
  private static final double SUSPICIOUS = 0.75;

  /** What is left of the old objects' room after a collection, when it is nearly nothing. */
  private static final double FULL = 0.92;

  /** Where old objects are; looked for when it matters, since that takes long. */
  private MemoryPoolMXBean old;

  /** Whether collecting garbage leaves nearly no room. */
  boolean isTight() {
    Runtime runtime = Runtime.getRuntime();
    double used = (double) runtime.totalMemory() - runtime.freeMemory();
    if (used < SUSPICIOUS * runtime.maxMemory()) {
      return false;
    }
    if (old == null) {
      old =
          ManagementFactory.getMemoryPoolMXBeans().stream()
              .filter(pool -> pool.getType() == MemoryType.HEAP)
              .max(Comparator.comparingLong(pool -> pool.getUsage().getMax()))
              .orElseThrow();
    }
    MemoryUsage left = old.getCollectionUsage();
    return left != null && left.getMax() > 0 && left.getUsed() > FULL * left.getMax();
  }
}
