package org.urbi.kernel.library.object;

import java.lang.ref.WeakReference;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.library.object.UrbiFinalizable.Reclaimable;
import org.urbi.kernel.node.Frame;

/**
 * Finds, after each statement of the top level, the finalizable objects that are no longer
 * referenced, and calls their {@code finalize}. Kernels without such objects pay nothing; others
 * run the garbage collector each time, so that runs can be repeated. Which objects it has found is
 * recorded: in a replay these are finalized, whatever its own collector does.
 */
public final class Finalization {
  /** How often to look for an object that the virtual machine has yet to hand over. */
  private static final long COLLECTION_TIMEOUT = 10_000_000;

  private final Journal journal;
  private final ConcurrentLinkedQueue<Reclaimable> reclaimed = new ConcurrentLinkedQueue<>();

  /** Those that have not been finalized, by their numbers. */
  private final Map<Long, WeakReference<Reclaimable>> alive = new HashMap<>();

  /** Those of them that only this map refers to; in a replay, all. */
  private final TreeMap<Long, Reclaimable> kept = new TreeMap<>();

  private long created;

  Finalization(Journal journal) {
    this.journal = journal;
  }

  /** The number of the next object. */
  long nextNumber() {
    return ++created;
  }

  /** One more object. */
  void add(Reclaimable object) {
    alive.put(object.number(), new WeakReference<>(object));
    if (journal.isReplay()) {
      kept.put(object.number(), object);
    }
  }

  /** Nobody refers to that object; on any thread. */
  void reclaimed(Reclaimable object) {
    if (!journal.isReplay()) {
      reclaimed.add(object);
    }
  }

  /** Calls {@code finalize} of the objects that are no longer referenced. */
  public void run(Frame frame) {
    if (alive.isEmpty()) {
      return;
    }
    for (long number : journal.ask(this::collect)) {
      Reclaimable object = kept.remove(number);
      // Another lobby can have come first, while the finalize of one before let others run.
      if (object != null) {
        alive.remove(number);
        finalize(frame, object);
      }
    }
  }

  private static void finalize(Frame frame, Reclaimable object) {
    try {
      frame.interpreter().send(frame, object, "finalize");
    } catch (UrbiException e) {
      frame.interpreter().report(frame.job(), e.unlessUncatchable());
    }
  }

  /**
   * Runs the garbage collector, and waits for what it has found, which the virtual machine hands
   * over from a thread of its own; returns the numbers of the objects, in their order.
   */
  private List<Long> collect() {
    System.gc();
    long found = alive.values().stream().filter(reference -> reference.refersTo(null)).count();
    for (long turns = 0; kept.size() < found && turns < COLLECTION_TIMEOUT; turns++) {
      Reclaimable next = reclaimed.poll();
      if (next == null) {
        Thread.onSpinWait();
      } else {
        kept.put(next.number(), next);
      }
    }
    return List.copyOf(kept.keySet());
  }
}
