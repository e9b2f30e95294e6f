package org.urbi.server.net;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;

/** The number of bytes that wait to be sent to all clients together. Any thread may use it. */
final class TotalOutput {
  private final long limit;
  private final AtomicLong unsent = new AtomicLong();
  private final AtomicInteger clients = new AtomicInteger();

  /**
   * @param limit how many bytes may wait
   */
  TotalOutput(long limit) {
    this.limit = limit;
  }

  /** Counts a new client. */
  void clientAdded() {
    clients.incrementAndGet();
  }

  /** Counts a client that has gone. */
  void clientRemoved() {
    clients.decrementAndGet();
  }

  /** Adds that many waiting bytes. */
  void add(long bytes) {
    unsent.addAndGet(bytes);
  }

  /**
   * Whether the total is too much and the share of that client so large that it must be
   * disconnected.
   */
  boolean isTooMuch(long ofClient) {
    return unsent.get() > limit && ofClient > limit / Math.max(1, clients.get());
  }
}
