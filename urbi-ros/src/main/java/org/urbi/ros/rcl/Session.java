package org.urbi.ros.rcl;

import java.lang.foreign.Arena;
import java.lang.foreign.MemorySegment;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.concurrent.locks.ReentrantReadWriteLock;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.rcl.CFunctions.Structure;
import org.urbi.ros.two.Reports;
import urbi.thread.GuardedThreads;

/**
 * A context of {@code rcl} with one node in it, and a thread that waits for changes of the graph.
 */
final class Session implements AutoCloseable {
  /** No structure that is kept here is larger. */
  private static final long ROOM = 256;

  private static final long ALLOCATOR = 40;
  private static final long FOR_EVER = -1;

  private final CFunctions c;
  private final Reports reports;
  private final Consumer<Throwable> troubles;
  private final Arena arena = Arena.ofAuto();
  private final MemorySegment allocator;
  private final MemorySegment context = arena.allocate(ROOM, Long.BYTES);
  private final MemorySegment node = arena.allocate(ROOM, Long.BYTES);
  private final MemorySegment waking = arena.allocate(ROOM, Long.BYTES);
  private final MemorySegment waitSet = arena.allocate(ROOM, Long.BYTES);
  private final Thread waiting;
  private final ReentrantReadWriteLock life = new ReentrantReadWriteLock();

  /**
   * Whoever makes or ends a part of the node: {@code rcl} keeps their types, for one thread at a
   * time.
   */
  private final ReentrantLock parts = new ReentrantLock();

  private volatile boolean closing;
  private boolean closed;

  /**
   * Begins.
   *
   * @param name the full name of the node
   * @param changed is called when the graph has changed, by a thread of its own
   * @param reports are told what that throws, and what else goes wrong
   */
  Session(CFunctions c, int domain, String name, Runnable changed, Reports reports) {
    this.c = c;
    this.reports = reports;
    this.troubles = trouble -> reports.tell("the graph", trouble);
    allocator = c.structure("rcutils_get_default_allocator", arena).asSlice(0, ALLOCATOR);
    MemorySegment options = arena.allocate(ROOM, Long.BYTES);
    c.check("rcl_init_options_init", options, new Structure(allocator));
    c.check("rcl_init_options_set_domain_id", options, (long) domain);
    c.check("rcl_init", 0, MemorySegment.NULL, options, context);
    c.end(troubles, "rcl_init_options_fini", options);
    try {
      initNode(name);
    } catch (RosException e) {
      endAll();
      throw e;
    }
    waiting = GuardedThreads.SDK.platform("urbi-ros-rcl-graph", () -> await(changed));
  }

  private void initNode(String name) {
    int slash = name.lastIndexOf('/');
    c.check(
        "rcl_node_init",
        node,
        name.substring(slash + 1),
        slash == 0 ? "/" : name.substring(0, slash),
        context,
        c.structure("rcl_node_get_default_options", arena));
    c.check(
        "rcl_guard_condition_init",
        waking,
        context,
        new Structure(
            c.structure("rcl_guard_condition_get_default_options", arena).asSlice(0, ALLOCATOR)));
    c.check(
        "rcl_wait_set_init", waitSet, 0L, 2L, 0L, 0L, 0L, 0L, context, new Structure(allocator));
  }

  /** From now on it is told when the graph has changed. */
  void begin() {
    waiting.start();
  }

  private void await(Runnable changed) {
    MemorySegment graph = c.pointer("rcl_node_get_graph_guard_condition", node);
    try {
      while (!closing) {
        c.check("rcl_wait_set_clear", waitSet);
        c.check("rcl_wait_set_add_guard_condition", waitSet, graph, MemorySegment.NULL);
        c.check("rcl_wait_set_add_guard_condition", waitSet, waking, MemorySegment.NULL);
        c.check("rcl_wait", waitSet, FOR_EVER);
        if (!closing) look(changed);
      }
    } catch (RuntimeException | Error e) {
      // No change of the graph is heard of any more.
      troubles.accept(e);
    }
  }

  private void look(Runnable changed) {
    try {
      changed.run();
    } catch (Throwable e) {
      troubles.accept(e);
    }
  }

  /** Has the graph looked at as if it had changed; nothing if the session is closed. */
  void wake() {
    life.readLock().lock();
    try {
      if (!closed) c.check("rcl_trigger_guard_condition", waking);
    } finally {
      life.readLock().unlock();
    }
  }

  /**
   * Does what needs the session, which is not closed meanwhile.
   *
   * @throws RosException if it is closed already
   */
  <T> T use(Supplier<T> action) {
    life.readLock().lock();
    try {
      if (closed) throw new RosException("the node is closed");
      return action.get();
    } finally {
      life.readLock().unlock();
    }
  }

  /** Like {@link #use(Supplier)}, for what has no result. */
  void use(Runnable action) {
    use(() -> {
      action.run();
      return this;
    });
  }

  /**
   * Makes or ends a part of the node, while nobody else does.
   *
   * @throws RosException if the session is closed already
   */
  void change(Runnable action) {
    use(() -> {
      parts.lock();
      try {
        action.run();
      } finally {
        parts.unlock();
      }
    });
  }

  /** Ends a part of the node by a function of C. What that says against it is told. */
  void end(String function, MemorySegment part) {
    change(() -> c.end(troubles, function, part, node));
  }

  MemorySegment node() {
    return node;
  }

  MemorySegment allocator() {
    return allocator;
  }

  CFunctions functions() {
    return c;
  }

  @Override
  public void close() {
    closing = true;
    wake();
    try {
      // What they may use must not be taken away.
      if (waiting.isAlive() && !comes("the thread that waits for changes", waiting::join)) return;
      if (!comes("a call of the middleware", this::lockedWithin)) return;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return;
    }
    try {
      closed = true;
      endAll();
    } finally {
      life.writeLock().unlock();
    }
  }

  private boolean lockedWithin(Duration time) throws InterruptedException {
    return life.writeLock().tryLock(time.toNanos(), TimeUnit.NANOSECONDS);
  }

  /** Whether something that is to end does so in the end. People are told if it takes long. */
  private boolean comes(String what, Patience.Awaited awaited) throws InterruptedException {
    String end = "the end of the node: ";
    boolean come = Patience.USUAL.await(awaited, () -> reports.tell(end + "waiting for " + what));
    if (!come) reports.tell(end + what + " does not end and is left behind");
    return come;
  }

  /** Each ends even if another does not; what has not begun takes no notice. */
  private void endAll() {
    c.end(troubles, "rcl_wait_set_fini", waitSet);
    c.end(troubles, "rcl_guard_condition_fini", waking);
    c.end(troubles, "rcl_node_fini", node);
    c.end(troubles, "rcl_shutdown", context);
    c.end(troubles, "rcl_context_fini", context);
  }
}
