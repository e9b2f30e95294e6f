package org.urbi.server.net;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;

/** What waits to be sent to all the clients together; from any thread. */
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

  /** There is one client more. */
  void come() {
    clients.incrementAndGet();
  }

  /** There is one client less. */
  void go() {
    clients.decrementAndGet();
  }

  /** So many bytes more wait. */
  void add(long bytes) {
    unsent.addAndGet(bytes);
  }

  /** Whether too much waits, and that client has so much of it that it has to go. */
  boolean isTooMuch(long ofClient) {
    return unsent.get() > limit && ofClient > limit / Math.max(1, clients.get());
  }
}
