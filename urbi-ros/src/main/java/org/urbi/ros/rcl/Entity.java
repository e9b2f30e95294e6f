package org.urbi.ros.rcl;

import java.lang.foreign.Arena;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.RosException;

/**
 * A publisher, subscription, client or service of {@code rcl}. It is used by one thread at a time,
 * and by none after it was closed.
 */
final class Entity implements AutoCloseable {
  private static final long ROOM = 64;
  private static final int OK = 0;

  /** There was nothing to take: for a subscription, a client, a service. */
  private static final int FIRST_TAKE_FAILED = 401;

  private static final int LAST_TAKE_FAILED = 601;

  private final Session session;
  private final CFunctions c;
  private final String kind;
  private final Arena arena = Arena.ofAuto();
  private final MemorySegment memory = arena.allocate(ROOM, Long.BYTES);
  private final SerializedBytes bytes;
  private boolean closed;

  /**
   * Makes one.
   *
   * @param kind {@code publisher}, {@code subscription}, {@code client} or {@code service}
   * @param support what the installation knows of its type
   * @param name the full name of the topic or service
   * @param delivery null for that of services
   * @throws RosException if that is not possible
   */
  Entity(
      Session session,
      String kind,
      MemorySegment support,
      String name,
      @Nullable Delivery delivery) {
    this.session = session;
    this.kind = kind;
    c = session.functions();
    bytes = new SerializedBytes(c, session.allocator(), arena);
    session.change(() -> init(support, name, delivery));
  }

  private void init(MemorySegment support, String name, @Nullable Delivery delivery) {
    try (Arena here = Arena.ofConfined()) {
      MemorySegment options = c.structure("rcl_" + kind + "_get_default_options", here);
      if (delivery != null) delivery.write(options);
      c.check("rcl_" + kind + "_init", memory, session.node(), support, name, options);
    }
  }

  /**
   * What uses it gets it, and memory for bytes; nothing is done if it is closed.
   *
   * @throws RosException if it is not, but the node is
   */
  synchronized void use(Consumer<MemorySegment> action) {
    if (closed) return;
    session.use(() -> action.accept(memory));
  }

  /** Memory for bytes that the entity sends, for code that holds the lock of {@link #use}. */
  SerializedBytes bytes() {
    return bytes;
  }

  /** To how many others it is connected, as a function of C counts them. */
  int count(String function) {
    try (Arena here = Arena.ofConfined()) {
      MemorySegment count = here.allocate(ValueLayout.JAVA_LONG);
      use(entity -> c.check(function, entity, count));
      return (int) count.get(ValueLayout.JAVA_LONG, 0);
    }
  }

  /** Memory that lives as long as this. */
  MemorySegment allocate(long size) {
    return arena.allocate(size, Long.BYTES);
  }

  /**
   * Takes something, if there is something.
   *
   * @throws RosException if that went wrong
   */
  boolean take(String function, Object... arguments) {
    int status = c.number(function, arguments);
    if (status >= FIRST_TAKE_FAILED && status <= LAST_TAKE_FAILED) {
      c.run("rcutils_reset_error");
      return false;
    }
    if (status != OK) throw new RosException(function + ": " + c.lastError());
    return true;
  }

  /** Has a source rung when something is there to be taken. */
  void hear(Arrivals.Source source, String what) {
    source.hear(c, "rcl_" + kind + "_set_on_new_" + what + "_callback", memory);
    // What came before was announced to nobody.
    source.ring();
  }

  @Override
  public synchronized void close() {
    if (closed) return;
    closed = true;
    bytes.close();
    session.end("rcl_" + kind + "_fini", memory);
  }
}
