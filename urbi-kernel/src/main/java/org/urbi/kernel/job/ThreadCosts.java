package org.urbi.kernel.job;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/**
 * What threads have cost so far. The JVM looks among all its beans each time it is asked for this
 * one, which takes longer than the measurement.
 */
public final class ThreadCosts {
  /** Made when somebody measures for the first time, which takes some milliseconds. */
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private ThreadCosts() {}

  /** Gets ready to measure: when memory is exhausted, that could fail for ever. */
  public static void prepare() {}

  /** The processor time of a platform thread, in nanoseconds. */
  static long processorTime(Thread thread) {
    return THREADS.getThreadCpuTime(thread.threadId());
  }

  /**
   * How many bytes a thread has allocated. Nobody knows it of a virtual one: then what the whole
   * process has allocated counts.
   */
  static long allocatedBytes(Thread thread) {
    return thread.isVirtual()
        ? allocatedBytesOfAll()
        : THREADS.getThreadAllocatedBytes(thread.threadId());
  }

  /** How many bytes all threads of the process have allocated. */
  static long allocatedBytesOfAll() {
    return THREADS.getTotalThreadAllocatedBytes();
  }
}
