package org.urbi.kernel;

import java.util.concurrent.CountDownLatch;

/** A function of urbiscript, {@code holdUp}, that keeps the kernel until it is to return. */
final class KernelHold {
  private final CountDownLatch begun = new CountDownLatch(1);
  private final CountDownLatch over = new CountDownLatch(1);

  /** Defines the function in that kernel. */
  KernelHold(Kernel kernel) {
    kernel.define(
        "holdUp",
        nothing -> {
          begun.countDown();
          // It spins, since a wait would be interrupted.
          while (over.getCount() > 0) {
            Thread.onSpinWait();
          }
          return null;
        });
  }

  /** Has a client call it, and returns when the kernel is held. */
  void begin(Connection holder) throws InterruptedException {
    holder.send("holdUp;\n");
    begun.await();
  }

  /** From now on it returns. */
  void end() {
    over.countDown();
  }
}
