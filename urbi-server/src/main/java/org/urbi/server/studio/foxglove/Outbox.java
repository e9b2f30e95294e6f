package org.urbi.server.studio.foxglove;

import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Queue;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.observe.Bytes;

/**
 * The values that wait until a program reads them: so many, then of each variable the latest alone.
 * Of images there is never more than that. From any thread.
 */
final class Outbox {
  /** How many values wait in their order. */
  private static final int MOST = 2000;

  /**
   * A value of a variable.
   *
   * @param channel the number of the variable
   * @param time in nanoseconds since the Epoch
   */
  record Value(int channel, long time, @Nullable Object value) {}

  private final Queue<Value> queue = new ArrayDeque<>();

  /** The latest values of those for which there was no room, until the queue is empty. */
  private final Map<Integer, Value> latest = new LinkedHashMap<>();

  private final Map<Integer, Value> images = new LinkedHashMap<>();
  private boolean imageIsNext;
  private boolean awaited = true;
  private long lost;

  /**
   * Takes a value.
   *
   * @return whether somebody waits who must be told that there is one
   */
  synchronized boolean put(Value value) {
    if (value.value() instanceof Bytes) {
      keep(images, value);
    } else if (queue.size() == MOST || latest.containsKey(value.channel)) {
      keep(latest, value);
    } else {
      queue.add(value);
    }
    boolean tell = awaited;
    awaited = false;
    return tell;
  }

  private void keep(Map<Integer, Value> where, Value value) {
    if (where.put(value.channel, value) != null) {
      lost++;
    }
  }

  /** The next value; null if there is none, and who asks is to be told of the next one. */
  synchronized @Nullable Value take() {
    // A queue that is never empty must not keep back all images.
    imageIsNext = !imageIsNext || queue.isEmpty() && latest.isEmpty();
    Value next = imageIsNext ? first(images) : null;
    if (next == null) {
      next = queue.poll();
    }
    if (next == null) {
      next = first(latest);
    }
    if (next == null) {
      next = first(images);
    }
    awaited = next == null;
    return next;
  }

  private static @Nullable Value first(Map<Integer, Value> from) {
    return from.isEmpty() ? null : from.remove(from.keySet().iterator().next());
  }

  /** How many values have been left out since this was last asked. */
  synchronized long lost() {
    long count = lost;
    lost = 0;
    return count;
  }
}
