package org.urbi.kernel.library.object;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/**
 * Finds out, after each statement of the top level, which finalizable objects nobody refers to any
 * more, and calls their {@code finalize}. Kernels that have none of these objects pay nothing; the
 * others have the memory looked through each time, so that runs repeat.
 */
public final class Finalization {
  /** How often to look for an object that the virtual machine has yet to hand over. */
  private static final long COLLECTION_TIMEOUT = 10_000_000;

  private final ConcurrentLinkedQueue<UrbiFinalizable> reclaimed = new ConcurrentLinkedQueue<>();
  private final List<WeakReference<UrbiFinalizable>> alive = new ArrayList<>();
  private long created;

  /** The number of the next object. */
  long nextNumber() {
    return ++created;
  }

  /** One more object. */
  void add(UrbiFinalizable object) {
    alive.add(new WeakReference<>(object));
  }

  /** Nobody refers to that object; on any thread. */
  void reclaimed(UrbiFinalizable object) {
    reclaimed.add(object);
  }

  /** Calls {@code finalize} of the objects to which nobody refers. */
  public void run(Frame frame) {
    if (alive.isEmpty()) {
      return;
    }
    System.gc();
    int before = alive.size();
    alive.removeIf(reference -> reference.refersTo(null));
    List<UrbiFinalizable> objects = take(before - alive.size());
    objects.sort(Comparator.comparingLong(UrbiFinalizable::number));
    for (UrbiObject object : objects) {
      try {
        frame.interpreter().send(frame, object, "finalize");
      } catch (UrbiException e) {
        frame.interpreter().report(frame.job(), e);
      }
    }
  }

  /** Waits for that many objects, which the virtual machine hands over from a thread of its own. */
  private List<UrbiFinalizable> take(int count) {
    List<UrbiFinalizable> objects = new ArrayList<>();
    long timeout = COLLECTION_TIMEOUT;
    while (objects.size() < count && timeout > 0) {
      UrbiFinalizable next = reclaimed.poll();
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
