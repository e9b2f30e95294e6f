package org.urbi.kernel.uobject;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.urbi.kernel.job.KernelThreadPin;
import org.urbi.kernel.node.Frame;

/**
 * The lock of the kernel by a thread ({@link urbi.UContext#lock}): a job occupies the kernel thread
 * and executes only the requests of the owner, until that unlocks it or dies.
 */
final class KernelLock {
  private static final long POLL_MILLISECONDS = 50;

  private final BlockingQueue<Consumer<Frame>> tasks = new LinkedBlockingQueue<>();
  private final Thread owner;
  private final BooleanSupplier over;
  private volatile boolean ended;
  private int depth = 1;

  /**
   * @param over whether the kernel has ended
   */
  KernelLock(Thread owner, BooleanSupplier over) {
    this.owner = owner;
    this.over = over;
  }

  /** Adds a request; called by the owner. */
  void add(Consumer<Frame> task) {
    tasks.add(task);
  }

  /** The owner locks once more. */
  void enter() {
    depth++;
  }

  /** The owner unlocks once: true if that was the outermost lock. */
  boolean end() {
    ended = --depth == 0;
    if (ended) {
      tasks.add(frame -> {});
    }
    return ended;
  }

  /** Executes the requests of the owner, and nothing else, until it unlocks; in a job. */
  void serve(Frame frame) {
    KernelThreadPin.pin();
    try {
      while (!ended && owner.isAlive() && !over.getAsBoolean()) {
        Consumer<Frame> task = tasks.poll(POLL_MILLISECONDS, TimeUnit.MILLISECONDS);
        if (task != null) {
          KernelThreadPin.unpin();
          try {
            task.accept(frame);
          } finally {
            KernelThreadPin.pin();
          }
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      KernelThreadPin.unpin();
    }
  }
}
