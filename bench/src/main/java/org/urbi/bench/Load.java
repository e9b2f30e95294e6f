package org.urbi.bench;

import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.locks.LockSupport;

/** How much else goes on on the machine, as the system has counted it over the last minute. */
public final class Load {
  private static final double CALM = 0.25;

  /** The build of the benchmarks alone makes a load that the mean of a minute keeps for as long. */
  private static final Duration PATIENCE = Duration.ofMinutes(3);

  private Load() {}

  /** Whether so little else goes on that figures mean something. */
  public static boolean isCalm() {
    return now() <= CALM * processors();
  }

  /** Waits until it is calm, for three minutes at most, and tells so; returns whether it is. */
  public static boolean becomesCalm(PrintStream progress) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    if (!isCalm()) {
      progress.println("waiting for a calm machine (" + text() + ") ...");
    }
    while (!isCalm() && System.nanoTime() < end) {
      LockSupport.parkNanos(Duration.ofSeconds(1).toNanos());
    }
    return isCalm();
  }

  /** How much it is, in words. */
  public static String text() {
    return String.format(Locale.ROOT, "load %.2f on %d processors", now(), processors());
  }

  private static double now() {
    return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
  }

  private static int processors() {
    return ManagementFactory.getOperatingSystemMXBean().getAvailableProcessors();
  }
}
