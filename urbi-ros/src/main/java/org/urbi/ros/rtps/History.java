package org.urbi.ros.rtps;

import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.time.SteadyClock;

/** The samples that a writer keeps, by number. */
final class History {
  /** Of one that keeps all: so many samples are on their way at most. */
  static final int ALL = 8192;

  private final TreeMap<Long, Change> changes = new TreeMap<>();
  private final int depth;
  private final boolean keepsAll;
  private final long memory;
  private long bytes;
  private long last;

  History(int depth, long memory) {
    keepsAll = depth == EndpointQos.KEEP_ALL;
    this.depth = keepsAll ? ALL : depth;
    this.memory = memory;
  }

  /** The greatest number that was ever given, 0 before the first. */
  long last() {
    return last;
  }

  /** The smallest number that is there; the one after {@link #last} if there is none. */
  long first() {
    return changes.isEmpty() ? last + 1 : changes.firstKey();
  }

  int depth() {
    return depth;
  }

  /**
   * Whether a sample of that size has to wait until others are gone; one that keeps the newest
   * never lets wait.
   */
  boolean isFullFor(int size) {
    return keepsAll && (changes.size() >= depth || bytes + size > memory);
  }

  /** Whether the oldest one has to go before a sample of that size comes. */
  boolean overflowsWith(int size) {
    return !keepsAll && !changes.isEmpty() && (changes.size() >= depth || bytes + size > memory);
  }

  long nextNumber() {
    return last + 1;
  }

  void add(Change change) {
    last = change.sequence();
    changes.put(last, change);
    bytes += change.size();
  }

  /** A number that no sample of the history has. */
  void skip() {
    last++;
  }

  @Nullable Change get(long sequence) {
    return changes.get(sequence);
  }

  /** The first one from {@code sequence} on. */
  @Nullable Change from(long sequence) {
    Map.Entry<Long, Change> entry = changes.ceilingEntry(sequence);
    return entry == null ? null : entry.getValue();
  }

  void removeOldest() {
    removed(changes.pollFirstEntry());
  }

  void remove(long sequence) {
    Change change = changes.remove(sequence);
    if (change != null) bytes -= change.size();
  }

  /** Removes all up to that number. */
  void removeUpTo(long sequence) {
    while (!changes.isEmpty() && changes.firstKey() <= sequence) removeOldest();
  }

  /**
   * Removes those that were written before that time, in terms of {@link SteadyClock#nanoseconds}.
   */
  void removeWrittenBefore(long time) {
    while (!changes.isEmpty() && changes.firstEntry().getValue().written() - time < 0)
      removeOldest();
  }

  private void removed(Map.@Nullable Entry<Long, Change> entry) {
    if (entry != null) bytes -= entry.getValue().size();
  }
}
