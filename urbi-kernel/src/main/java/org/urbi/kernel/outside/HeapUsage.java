package org.urbi.kernel.outside;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.ThreadCosts;

/** How full the heap of this process is. */
public final class HeapUsage implements Heap {
  /** Below this share of the heap, memory needs no closer look. */
  private static final double SCARCE = 0.6;

  private static final long MILLISECOND = 1_000_000;

  /** So many times memory is kept: somebody is asked, lets go of its jobs, then of its lobby. */
  private static final int RESERVES = 4;

  /** How many bytes are kept each time, for when there are no others left. */
  private static final int RESERVE = 4_000_000;

  /** No more than this fraction of the heap, a 64th, is kept each time. */
  private static final int RESERVE_PART = 64;

  /** Whole regions are no more than this fraction of the heap, a 6th, in all, but for the first. */
  private static final int REGIONS_PART = 6;

  /** More than what an array has beside its bytes. */
  private static final int HEADER = 64;

  /**
   * The old generation; looked up only in programs that live for some time, because that takes
   * long.
   */
  private @Nullable MemoryPoolMXBean old;

  // In arrays: who goes through a list makes an object, for which there may be no memory.
  private GarbageCollectorMXBean[] collectors = {};
  private GarbageCollectorMXBean[] oldCollectors = {};
  private final RoomLeft room = new RoomLeft();
  private byte[] @Nullable [] reserves = new byte[RESERVES][];
  private int reserve = (int) Math.min(RESERVE, all() / RESERVE_PART);

  @Override
  public boolean isScarce() {
    Runtime runtime = Runtime.getRuntime();
    double used = (double) runtime.totalMemory() - runtime.freeMemory();
    return used >= SCARCE * runtime.maxMemory();
  }

  /** How many bytes the heap may have. */
  public static long all() {
    return Runtime.getRuntime().maxMemory();
  }

  /** How many bytes are free, with all that the heap may still grow by; from any thread. */
  public static long free() {
    Runtime runtime = Runtime.getRuntime();
    return runtime.maxMemory() - runtime.totalMemory() + runtime.freeMemory();
  }

  /**
   * Finds what it measures with, and what others measure with: when memory is exhausted, the JVM
   * may fail to make that, and then never tries again.
   */
  public void prepare() {
    ThreadCosts.prepare();
    oldGeneration();
  }

  private MemoryPoolMXBean oldGeneration() {
    MemoryPoolMXBean known = old;
    if (known == null) {
      known =
          ManagementFactory.getMemoryPoolMXBeans().stream()
              .filter(pool -> pool.getType() == MemoryType.HEAP)
              .max(Comparator.comparingLong(pool -> pool.getUsage().getMax()))
              .orElseThrow();
      old = known;
      // Concurrent collectors do not stop the program.
      collectors =
          ManagementFactory.getGarbageCollectorMXBeans().stream()
              .filter(bean -> !bean.getName().matches(".*(Cycles|Concurrent).*"))
              .toArray(GarbageCollectorMXBean[]::new);
      String name = known.getName();
      oldCollectors =
          Arrays.stream(collectors)
              .filter(bean -> List.of(bean.getMemoryPoolNames()).contains(name))
              .filter(bean -> !bean.getName().contains("Young"))
              .toArray(GarbageCollectorMXBean[]::new);
      if (name.startsWith("G1")) {
        reserveRegions();
      }
    }
    return known;
  }

  /**
   * G1 gives memory by whole regions: what is free in one of which a part is in use is of no use.
   * An array that fills more than half of a region has it alone, and it is free with the array.
   */
  private void reserveRegions() {
    var machine = ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class);
    long region = Long.parseLong(machine.getVMOption("G1HeapRegionSize").getValue());
    reserve = (int) (region / 2) + HEADER;
    reserves = new byte[Math.clamp(all() / REGIONS_PART / region, 1, RESERVES)][];
  }

  @Override
  public boolean isNearlyFull(long now) {
    MemoryUsage left = oldGeneration().getCollectionUsage();
    double used = left != null && left.getMax() > 0 ? (double) left.getUsed() / left.getMax() : 0;
    return room.isTooLittle(now, used, collecting(), count(collectors), collections());
  }

  @Override
  public boolean isExhausted() {
    return free() < (1 - RoomLeft.FULL) * Runtime.getRuntime().maxMemory();
  }

  @Override
  public void forget() {
    room.forget();
  }

  @Override
  public void expectRelief() {
    room.expectRelief();
  }

  @Override
  public long collections() {
    return count(oldCollectors);
  }

  private static long count(GarbageCollectorMXBean[] of) {
    long count = 0;
    for (GarbageCollectorMXBean each : of) {
      count += each.getCollectionCount();
    }
    return count;
  }

  @Override
  public long collecting() {
    long collected = 0;
    for (GarbageCollectorMXBean each : collectors) {
      collected += each.getCollectionTime();
    }
    return collected * MILLISECOND;
  }

  @Override
  public void collect() {
    System.gc();
  }

  @Override
  public void keepReserve() {
    for (int i = 0; i < reserves.length; i++) {
      if (reserves[i] == null) {
        reserves[i] = new byte[reserve];
      }
    }
  }

  @Override
  public void releaseReserve() {
    for (int i = 0; i < reserves.length; i++) {
      if (reserves[i] != null) {
        reserves[i] = null;
        return;
      }
    }
  }
}
