package org.urbi.bench;

import java.lang.management.ManagementFactory;
import java.util.Locale;

/** How much else goes on on the machine, as the system has counted it over the last minute. */
public final class Load {
  private static final double CALM = 0.25;

  private Load() {}

  /** Whether so little else goes on that figures mean something. */
  public static boolean isCalm() {
    return now() <= CALM * processors();
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
