package org.urbi.ros.bridge;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.bridge.WebSocket.Frame;

/**
 * What waits to be sent to a client. Of messages of a topic the oldest are dropped when there are
 * too many; a client that does not even take the answers to what it has asked is let go.
 */
final class Outbox {
  /** Messages of all topics together that wait at most. */
  private static final int MOST = 1000;

  /** Bytes that wait at most. */
  private static final long LARGEST = 64L << 20;

  private record Entry(Frame frame, @Nullable Object topic) {}

  private final Deque<Entry> waiting = new ArrayDeque<>();
  private long size;
  private boolean closed;

  /** An answer; false if there is no room for it: the client does not read. */
  synchronized boolean answer(Frame frame) {
    if (size + frame.size() > LARGEST) {
      dropTopics();
    }
    if (waiting.size() >= 2 * MOST || size + frame.size() > LARGEST) {
      return false;
    }
    add(new Entry(frame, null));
    return true;
  }

  private void dropTopics() {
    waiting.removeIf(each -> each.topic() != null);
    size = waiting.stream().mapToLong(each -> each.frame().size()).sum();
  }

  /**
   * A message of a topic.
   *
   * @param topic which of the subscriptions it is
   * @param most how many of that wait at most; 0 for no limit of its own
   */
  synchronized void publish(Frame frame, Object topic, int most) {
    int own = 0;
    int all = 0;
    for (Entry each : waiting) {
      own += each.topic() == topic ? 1 : 0;
      all += each.topic() != null ? 1 : 0;
    }
    while (own > 0 && (most > 0 && own >= most || all >= MOST || size + frame.size() > LARGEST)) {
      dropOldest(topic);
      own--;
      all--;
    }
    if (all < MOST && size + frame.size() <= LARGEST) {
      add(new Entry(frame, topic));
    }
  }

  private void dropOldest(Object topic) {
    for (var all = waiting.iterator(); all.hasNext(); ) {
      Entry each = all.next();
      if (each.topic() == topic) {
        all.remove();
        size -= each.frame().size();
        return;
      }
    }
  }

  private void add(Entry entry) {
    if (!closed) {
      waiting.addLast(entry);
      size += entry.frame().size();
      notifyAll();
    }
  }

  /** The next one; waits until there is one. Null when it is closed. */
  synchronized @Nullable Frame take() throws InterruptedException {
    while (waiting.isEmpty() && !closed) {
      wait();
    }
    Entry next = waiting.pollFirst();
    if (next == null) {
      return null;
    }
    size -= next.frame().size();
    return next.frame();
  }

  /** Nothing more is sent. */
  synchronized void close() {
    closed = true;
    waiting.clear();
    size = 0;
    notifyAll();
  }
}
