package org.urbi.ros.rcl;

import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import org.urbi.ros.graph.Qos;

/** How messages are delivered, in the words of {@code rmw_qos_profile_t}. */
record Delivery(Qos qos) {
  private static final int KEEP_LAST = 1;
  private static final int KEEP_ALL = 2;
  private static final int RELIABLE = 1;
  private static final int BEST_EFFORT = 2;
  private static final int TRANSIENT_LOCAL = 1;
  private static final int VOLATILE = 2;
  private static final int BEST_AVAILABLE = 4;

  private static final long HISTORY = 0;
  private static final long DEPTH = 8;
  private static final long RELIABILITY = 16;
  private static final long DURABILITY = 20;
  private static final long DEADLINE = 24;
  private static final long DEADLINE_NANOSECONDS = 32;

  /** Has options say it, which begin with what says it. */
  void write(MemorySegment options) {
    set(options, HISTORY, qos.depth() == 0 ? KEEP_ALL : KEEP_LAST);
    options.set(ValueLayout.JAVA_LONG, DEPTH, qos.depth());
    set(options, RELIABILITY, reliability());
    set(options, DURABILITY, durability());
    options.set(ValueLayout.JAVA_LONG, DEADLINE, qos.deadline().toSeconds());
    options.set(ValueLayout.JAVA_LONG, DEADLINE_NANOSECONDS, qos.deadline().toNanosPart());
  }

  private static void set(MemorySegment options, long at, int value) {
    options.set(ValueLayout.JAVA_INT, at, value);
  }

  private int reliability() {
    if (qos.asOffered()) return BEST_AVAILABLE;
    return qos.reliable() ? RELIABLE : BEST_EFFORT;
  }

  private int durability() {
    if (qos.asOffered()) return BEST_AVAILABLE;
    return qos.keptForLate() ? TRANSIENT_LOCAL : VOLATILE;
  }

  /** What others offer, or ask for: the stronger, the smaller the numbers are. */
  record Offer(int reliability, int durability) {
    static Offer of(MemorySegment profile) {
      return new Offer(
          profile.get(ValueLayout.JAVA_INT, RELIABILITY),
          profile.get(ValueLayout.JAVA_INT, DURABILITY));
    }

    /** In what this is less than what is asked for; empty if it is enough. */
    String lacks(Offer asked) {
      if (reliability > asked.reliability) return "reliability";
      return durability > asked.durability ? "durability" : "";
    }
  }

  /** What this offers, or asks for. */
  Offer offer() {
    return new Offer(reliability(), durability());
  }
}
