package org.urbi.kernel.library.object;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.library.object.UrbiFinalizable.Reclaimable;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/**
 * Finds, after each statement of the top level, the finalizable objects that are no longer
 * referenced, and calls their {@code finalize}. Kernels without such objects pay nothing; others
 * run the garbage collector each time, so that runs can be repeated.
 */
public final class Finalization {
  /** How often to look for an object that the virtual machine has yet to hand over. */
  private static final long COLLECTION_TIMEOUT = 10_000_000;

  private final ConcurrentLinkedQueue<Reclaimable> reclaimed = new ConcurrentLinkedQueue<>();
  private final List<WeakReference<Reclaimable>> alive = new ArrayList<>();
  private long created;

  /** The number of the next object. */
  long nextNumber() {
    return ++created;
  }

  /** One more object. */
  void add(Reclaimable object) {
    alive.add(new WeakReference<>(object));
  }

  /** Nobody refers to that object; on any thread. */
  void reclaimed(Reclaimable object) {
    reclaimed.add(object);
  }

  /** Calls {@code finalize} of the objects that are no longer referenced. */
  public void run(Frame frame) {
    if (alive.isEmpty()) {
      return;
    }
    System.gc();
    int before = alive.size();
    alive.removeIf(reference -> reference.refersTo(null));
    List<Reclaimable> objects = take(before - alive.size());
    objects.sort(Comparator.comparingLong(Reclaimable::number));
    for (UrbiObject object : objects) {
      try {
        frame.interpreter().send(frame, object, "finalize");
      } catch (UrbiException e) {
        frame.interpreter().report(frame.job(), e.unlessUncatchable());
      }
    }
  }

  /** Waits for that many objects, which the virtual machine hands over from a thread of its own. */
  private List<Reclaimable> take(int count) {
    List<Reclaimable> objects = new ArrayList<>();
    long timeout = COLLECTION_TIMEOUT;
    while (objects.size() < count && timeout > 0) {
      Reclaimable next = reclaimed.poll();
      if (next == null) {
        timeout--;
        Thread.onSpinWait();
      } else {
        objects.add(next);
      }
    }
    return objects;
  }
}
