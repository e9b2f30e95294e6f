package org.urbi.kernel.library.object;

import java.lang.ref.WeakReference;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.library.object.UrbiFinalizable.Reclaimable;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.time.Clock;

/**
 * Finds, after each statement of the top level, the finalizable objects that are no longer
 * referenced, and calls their {@code finalize}. Kernels without such objects pay nothing. Where
 * code with the role owner has made some, the garbage collector runs after each statement with that
 * role, so that runs can be repeated; while another lobby has jobs, only as often as it {@linkplain
 * CollectionPace may} stop these. Code of others may not stop everybody for that, so theirs are
 * finalized when it has run for whatever reason. Which objects it has found is recorded: in a
 * replay these are finalized, whatever its own collector does.
 */
public final class Finalization {
  /** Whose code is running. */
  interface Running {
    /** Whether it has the role owner. */
    boolean isOwner();

    /** Its lobby; null if no code is running. */
    @Nullable UrbiObject lobby();

    /** Whether nobody else is kept waiting by what it does. */
    boolean isAlone();
  }

  /** How often to look for an object that the virtual machine has yet to hand over. */
  private static final long COLLECTION_TIMEOUT = 10_000_000;

  private final Journal journal;
  private final Running running;
  private final Runnable collector;
  private final CollectionPace pace;
  private final ConcurrentLinkedQueue<Reclaimable> reclaimed = new ConcurrentLinkedQueue<>();

  /** The objects that code of owners has made, and that have not been found, by their numbers. */
  private final Map<Long, WeakReference<Reclaimable>> ofOwners = new HashMap<>();

  /** The objects that were found, and are to be finalized; in a replay, all. */
  private final TreeMap<Long, Reclaimable> kept = new TreeMap<>();

  private long created;
  private long finalized;

  /**
   * @param running whose code makes an object, or has made a statement
   * @param collector runs the garbage collector
   * @param machine the time that it takes
   */
  Finalization(Journal journal, Running running, Runnable collector, Clock machine) {
    this.journal = journal;
    this.running = running;
    this.collector = collector;
    pace = new CollectionPace(machine);
  }

  /** Whose code is running. */
  Running running() {
    return running;
  }

  /** The number of the next object. */
  long nextNumber() {
    return ++created;
  }

  /** One more object. */
  void add(Reclaimable object) {
    if (journal.isReplay()) {
      kept.put(object.number(), object);
    } else if (running.isOwner()) {
      ofOwners.put(object.number(), new WeakReference<>(object));
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
    if (created == finalized) {
      return;
    }
    for (long number : journal.ask(this::found)) {
      Reclaimable object = kept.remove(number);
      // Another lobby can have come first, while the finalize of one before let others run.
      if (object != null) {
        finalized++;
        finalize(frame, object);
      }
    }
  }

  private static void finalize(Frame frame, Reclaimable object) {
    Job job = frame.job();
    UrbiObject maker = object.maker();
    try {
      // Whose statement happens to be over lends the object no rights.
      job.identity()
          .doFor(
              maker == null ? job.lobby() : maker,
              () -> frame.interpreter().send(frame, object, "finalize"));
    } catch (UrbiException e) {
      frame.interpreter().report(job, e.unlessUncatchable());
    }
  }

  /** The numbers of the objects that are no longer referenced, as far as is known. */
  List<Long> found() {
    if (ofOwners.isEmpty() || !running.isOwner()) {
      take();
    } else if (running.isAlone()) {
      collect();
    } else if (pace.allows()) {
      pace.measure(this::collect);
    } else {
      take();
    }
    return List.copyOf(kept.keySet());
  }

  /**
   * Runs the garbage collector, and waits for what it has found of those of owners, which the
   * virtual machine hands over from a thread of its own.
   */
  private void collect() {
    collector.run();
    long left = ofOwners.values().stream().filter(reference -> !reference.refersTo(null)).count();
    take();
    for (long turns = 0; ofOwners.size() > left && turns < COLLECTION_TIMEOUT; turns++) {
      Thread.onSpinWait();
      take();
    }
  }

  /** Takes what has been handed over. */
  private void take() {
    Reclaimable next;
    while ((next = reclaimed.poll()) != null) {
      kept.put(next.number(), next);
      ofOwners.remove(next.number());
    }
  }
}
