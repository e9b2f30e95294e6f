package org.urbi.ros.frames;

import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** Where a frame was in another one, in the last seconds. */
final class FrameHistory {
  /** Nanoseconds that are kept, and times that are kept at most. */
  private static final long KEPT = 10_000_000_000L;

  private static final int MOST = 10_000;

  /** Nanoseconds by which a number of urbiscript may miss the time that it means. */
  private static final long ROUNDING = 1000;

  private static final double SECOND = 1e9;

  /**
   * Where it was at a time.
   *
   * @param parent the other frame
   */
  record Place(String parent, Transform transform) {}

  private final String frame;
  private final TreeMap<Long, Place> places = new TreeMap<>();
  private boolean fixed;

  FrameHistory(String frame) {
    this.frame = frame;
  }

  /** The frame is at that place, at all times. */
  void fix(Place place) {
    places.clear();
    places.put(0L, place);
    fixed = true;
  }

  /** Whether it is there at all times. */
  boolean isFixed() {
    return fixed;
  }

  /** The frame was at that place at a time; what is too old is not kept. */
  void add(long time, Place place) {
    if (fixed) {
      places.clear();
      fixed = false;
    }
    if (!places.isEmpty() && time < places.lastKey() - KEPT) {
      return;
    }
    places.put(time, place);
    places.headMap(places.lastKey() - KEPT).clear();
    if (places.size() > MOST) {
      places.pollFirstEntry();
    }
  }

  /** The frame in which it was last. */
  String parent() {
    return places.lastEntry().getValue().parent;
  }

  /** The newest time; the greatest number there is if it is the same at all times. */
  long newest() {
    return fixed ? Long.MAX_VALUE : places.lastKey();
  }

  /**
   * Where it was at a time.
   *
   * @throws FrameException if that is not known
   */
  Place at(long time) {
    if (fixed) {
      return places.firstEntry().getValue();
    }
    Map.Entry<Long, Place> before = places.floorEntry(time + ROUNDING);
    Map.Entry<Long, Place> after = places.ceilingEntry(time - ROUNDING);
    if (before == null || after == null) {
      throw new FrameException(
          String.format(
              Locale.ROOT,
              "where %s was in %s is known from %.6f to %.6f, not at %.6f (%.6f s too %s)",
              frame,
              parent(),
              places.firstKey() / SECOND,
              places.lastKey() / SECOND,
              time / SECOND,
              (before == null ? places.firstKey() - time : time - places.lastKey()) / SECOND,
              before == null ? "early" : "late"));
    }
    Place earlier = before.getValue();
    Place later = after.getValue();
    // From one frame to another there is nothing between.
    if (before.getKey() >= after.getKey() || !earlier.parent.equals(later.parent)) {
      return earlier;
    }
    double share = (double) (time - before.getKey()) / (after.getKey() - before.getKey());
    return new Place(earlier.parent, earlier.transform.towards(later.transform, share));
  }
}
