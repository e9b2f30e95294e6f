package org.urbi.kernel.library;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/**
 * Finds out, after each statement of the top level, which finalizable objects nobody refers to any
 * more, and calls their {@code finalize}. Kernels that have none of these objects pay nothing; the
 * others have the memory looked through each time, so that runs repeat.
 */
final class Finalization {
  private static final Map<World, Finalization> ALL = new WeakHashMap<>();

  private final ConcurrentLinkedQueue<UrbiFinalizable> reclaimed = new ConcurrentLinkedQueue<>();
  private final AtomicLong alive = new AtomicLong();
  private long created;

  private Finalization() {}

  /** That of a kernel. */
  static Finalization of(World world) {
    synchronized (ALL) {
      return ALL.computeIfAbsent(world, key -> new Finalization());
    }
  }

  /** One more object; its number. */
  long created() {
    alive.incrementAndGet();
    return ++created;
  }

  /** Nobody refers to that object; on any thread. */
  void reclaimed(UrbiFinalizable object) {
    reclaimed.add(object);
    alive.decrementAndGet();
  }

  /** Calls {@code finalize} of the objects to which nobody refers. */
  @SuppressWarnings("removal")
  void run(Frame frame) {
    if (alive.get() == 0 && reclaimed.isEmpty()) {
      return;
    }
    System.gc();
    Runtime.getRuntime().runFinalization();
    List<UrbiFinalizable> objects = new ArrayList<>();
    UrbiFinalizable next;
    while ((next = reclaimed.poll()) != null) {
      objects.add(next);
    }
    objects.sort(Comparator.comparingLong(UrbiFinalizable::number));
    for (UrbiObject object : objects) {
      try {
        frame.interpreter().send(frame, object, "finalize");
      } catch (UrbiException e) {
        frame.interpreter().report(frame.job(), e);
      }
    }
  }
}
