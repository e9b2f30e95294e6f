package org.urbi.server.cli;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.lang.management.ManagementFactory;

/** The memory of a server: some of it is kept free for what comes suddenly. */
final class ServerHeap {
  /** The share that is used before garbage is collected, in per cent. */
  private static final long USED = 50;

  private static final String SOFT_LIMIT = "SoftMaxHeapSize";

  private ServerHeap() {}

  /**
   * Makes a collector that works beside the program begin early enough. By itself it waits until as
   * much is left as is allocated in the time of a collection, as far as it knows; clients that come
   * together need more. What the user has set stays.
   */
  static void keepRoom() {
    HotSpotDiagnosticMXBean machine =
        ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class);
    boolean concurrent = Boolean.parseBoolean(machine.getVMOption("UseZGC").getValue());
    long most = Runtime.getRuntime().maxMemory();
    long soft = Long.parseLong(machine.getVMOption(SOFT_LIMIT).getValue());
    if (concurrent && soft == most) {
      machine.setVMOption(SOFT_LIMIT, String.valueOf(most * USED / 100));
    }
  }
}
