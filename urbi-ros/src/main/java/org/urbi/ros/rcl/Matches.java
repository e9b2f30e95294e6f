package org.urbi.ros.rcl;

import java.lang.foreign.MemorySegment;

/** Has the graph looked at again when a publisher is connected to others, or is not any more. */
final class Matches implements AutoCloseable {
  private static final int PUBLISHER_MATCHED = 4;
  private static final long ROOM = 64;

  private final CFunctions c;
  private final Entity publisher;
  private final MemorySegment event;
  private final Arrivals.Source source;

  Matches(Session session, Entity publisher, Arrivals arrivals) {
    c = session.functions();
    this.publisher = publisher;
    event = publisher.allocate(ROOM);
    source = arrivals.source(session::wake);
    publisher.use(memory -> c.check("rcl_publisher_event_init", event, memory, PUBLISHER_MATCHED));
    source.hear(c, "rcl_event_set_callback", event);
  }

  @Override
  public void close() {
    source.close();
    // By one thread at a time, and while there is the publisher.
    publisher.use(memory -> c.number("rcl_event_fini", event));
  }
}
