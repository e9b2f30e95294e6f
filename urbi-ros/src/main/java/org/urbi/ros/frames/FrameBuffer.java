package org.urbi.ros.frames;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/** Where frames are in others, now and in the last ten seconds. May be used by any threads. */
public final class FrameBuffer {
  /** For the newest time at which all that is needed is known. */
  public static final long NEWEST = 0;

  /** Frames that are known at most. */
  private static final int MOST = 10_000;

  private final SortedMap<String, FrameHistory> frames = new TreeMap<>();

  /**
   * A frame was somewhere.
   *
   * @param time nanoseconds since 1970
   * @param fixed whether it is there at all times
   * @throws FrameException if that cannot be
   */
  public synchronized void put(
      String parent, String frame, Transform transform, long time, boolean fixed) {
    String outer = name(parent);
    String inner = name(frame);
    if (outer.isEmpty() || inner.isEmpty() || outer.equals(inner)) {
      throw new FrameException("'" + inner + "' cannot be in '" + outer + "'");
    }
    FrameHistory.Place place = new FrameHistory.Place(outer, transform.normalized());
    FrameHistory known = frames.get(inner);
    if (known == null) {
      if (frames.size() >= MOST) {
        throw new FrameException("there are more than " + MOST + " frames, " + inner + " is one");
      }
      known = new FrameHistory(inner);
      frames.put(inner, known);
    }
    if (fixed) {
      known.fix(place);
    } else {
      known.add(time, place);
    }
  }

  /** Names of ROS 1 may begin with a slash that ROS 2 does not have. */
  private static String name(String written) {
    return written.startsWith("/") ? written.substring(1) : written;
  }

  /** Time has jumped back: forgets all but what is there at all times, which nobody tells again. */
  public synchronized void clear() {
    frames.values().removeIf(each -> !each.isFixed());
  }

  /** Each frame and the one in which it was last. */
  public synchronized Map<String, String> parents() {
    Map<String, String> all = new LinkedHashMap<>();
    frames.forEach((frame, history) -> all.put(frame, history.parent()));
    return all;
  }

  /**
   * Where a frame is.
   *
   * @param time when; 0 if it is there at all times
   */
  public record Found(Transform transform, long time) {}

  /**
   * Where {@code source} was in {@code target}: what makes points of the one points of the other.
   *
   * @param time nanoseconds since 1970, or {@link #NEWEST}
   * @throws FrameException if that is not known: what is missing
   */
  public synchronized Found lookup(String target, String source, long time) {
    String to = name(target);
    String from = name(source);
    check(to);
    check(from);
    long when = time == NEWEST ? newest(to, from) : time;
    Path above = path(to, when, Map.of());
    Path below = path(from, when, above.places);
    for (Map.Entry<String, Transform> each : below.places.entrySet()) {
      Transform outer = above.places.get(each.getKey());
      if (outer != null) {
        return new Found(outer.inverse().then(each.getValue()), when == Long.MAX_VALUE ? 0 : when);
      }
    }
    if (below.end != null) {
      throw below.end;
    }
    throw above.end != null ? above.end : unconnected(to, from);
  }

  private void check(String frame) {
    boolean isThere =
        frames.containsKey(frame)
            || frames.values().stream().anyMatch(each -> each.parent().equals(frame));
    if (!isThere) {
      throw new FrameException(
          "nobody has told of a frame '"
              + frame
              + "' on /tf or /tf_static: "
              + (frames.isEmpty() ? "there is none yet" : "there are " + frames.keySet()));
    }
  }

  private FrameException unconnected(String one, String other) {
    return new FrameException(
        "'%s' and '%s' are not connected: the one is within '%s', the other within '%s'"
            .formatted(one, other, root(one), root(other)));
  }

  private String root(String frame) {
    String last = frame;
    // Circles end, too.
    for (int i = 0; i < frames.size() && frames.containsKey(last); i++) {
      last = history(last).parent();
    }
    return last;
  }

  private FrameHistory history(String frame) {
    FrameHistory known = frames.get(frame);
    if (known == null) {
      throw new FrameException("there is no frame '" + frame + "'");
    }
    return known;
  }

  /**
   * A frame and all that it is in, from the inside to the outside, with where it is in them.
   *
   * @param end why it is not known where that is which is the last one; what is further out need
   *     not matter
   */
  private record Path(Map<String, Transform> places, @Nullable FrameException end) {}

  private Path path(String frame, long time, Map<String, Transform> ends) {
    Map<String, Transform> path = new LinkedHashMap<>();
    Transform sum = Transform.IDENTITY;
    String at = frame;
    while (path.putIfAbsent(at, sum) == null) {
      if (!frames.containsKey(at) || ends.containsKey(at)) {
        return new Path(path, null);
      }
      try {
        FrameHistory.Place place = history(at).at(time);
        sum = place.transform().then(sum);
        at = place.parent();
      } catch (FrameException e) {
        return new Path(path, e);
      }
    }
    return new Path(path, circle(at, path));
  }

  private static FrameException circle(String frame, Map<String, ?> path) {
    return new FrameException("'" + frame + "' is within itself: " + path.keySet());
  }

  /** The newest time at which all between the two is known. */
  private long newest(String to, String from) {
    Map<String, Long> above = times(to);
    Map<String, Long> below = times(from);
    for (Map.Entry<String, Long> each : below.entrySet()) {
      Long outer = above.get(each.getKey());
      if (outer != null) {
        return Math.min(outer, each.getValue());
      }
    }
    throw unconnected(to, from);
  }

  /** A frame and all that it is in, with the newest time at which that is known. */
  private Map<String, Long> times(String frame) {
    Map<String, Long> times = new LinkedHashMap<>();
    long oldest = Long.MAX_VALUE;
    String at = frame;
    while (times.putIfAbsent(at, oldest) == null) {
      if (!frames.containsKey(at)) {
        return times;
      }
      oldest = Math.min(oldest, history(at).newest());
      at = history(at).parent();
    }
    throw circle(at, times);
  }
}
