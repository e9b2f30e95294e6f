package org.urbi.kernel.uobject;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.urbi.kernel.job.KernelThreadPin;
import org.urbi.kernel.node.Frame;

/**
 * A thread that has the kernel for itself ({@link urbi.UContext#lock}): a job keeps the kernel
 * thread, and does what that thread asks for, until it says that it has done or has gone.
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

  /** Asks for something; by the owner. */
  void add(Consumer<Frame> task) {
    tasks.add(task);
  }

  /** The owner wants it once more. */
  void enter() {
    depth++;
  }

  /** The owner wants it once less: true if that was the last time. */
  boolean end() {
    ended = --depth == 0;
    if (ended) {
      tasks.add(frame -> {});
    }
    return ended;
  }

  /** Does what the owner asks for, and nothing else, until the end; in a job. */
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
