package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.util.BitSet;
import java.util.TreeMap;
import org.urbi.ros.time.SteadyClock;

/** What a writer knows of one of the readers that it serves. */
final class ReaderProxy {
  final Guid guid;
  final boolean reliable;
  final InetSocketAddress address;

  /**
   * The first sample that concerns it: what was written before it came does not, if it did not ask
   * for that.
   */
  final long start;

  /** Whether it wants what was written before it came. */
  final boolean wantsAll;

  /** Fragments that it asked for again, by the number of their sample, the first one being 0. */
  final TreeMap<Long, BitSet> requested = new TreeMap<>();

  /** All samples up to this one have arrived. */
  long acknowledged;

  /** Whether it has ever answered. */
  boolean isKnown;

  /** Whether it has not answered for some time: others do not wait for it. */
  boolean lags;

  /** When it last acknowledged something, or had nothing to acknowledge. */
  long progress = SteadyClock.nanoseconds();

  /** When it was last told where it begins. */
  long introduced = progress;

  private int count = -1;

  ReaderProxy(
      Guid guid, boolean reliable, InetSocketAddress address, boolean wantsAll, long start) {
    this.guid = guid;
    this.reliable = reliable;
    this.address = address;
    this.wantsAll = wantsAll;
    this.start = start;
    acknowledged = start - 1;
  }

  /** Whether that answer has not been seen before. */
  boolean isNew(int answer) {
    boolean isNew = answer != count;
    count = answer;
    return isNew;
  }
}
