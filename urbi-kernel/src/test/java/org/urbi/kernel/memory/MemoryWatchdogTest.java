package org.urbi.kernel.memory;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.TestTimeout;

/** The one thread that looks after the memory of all kernels. */
class MemoryWatchdogTest {
  /** A kernel with a defect, which is looked after all the same. */
  private static final class Defective implements MemoryUser {
    private final CountDownLatch prepared = new CountDownLatch(1);
    private final CountDownLatch looked = new CountDownLatch(2);

    @Override
    public void prepare() {
      prepared.countDown();
      throw new IllegalStateException("cannot prepare");
    }

    @Override
    public void memoryScarce(boolean scarce) {
      looked.countDown();
      throw new IllegalStateException("cannot hear that");
    }

    @Override
    public double growth() {
      throw new IllegalStateException("does not know");
    }

    @Override
    public void relieve() {
      throw new IllegalStateException("cannot give");
    }

    @Override
    public boolean isDone() {
      throw new IllegalStateException("does not know that, either");
    }

    @Override
    public void memoryNearlyFull(boolean full) {}

    @Override
    public void memoryExhausted() {}
  }

  @Test
  void defectsOfKernelsDoNotEndIt() throws InterruptedException {
    var kernel = new Defective();
    // The one of the process may still be there from the kernels of other tests.
    var watchdog = new MemoryWatchdog();
    watchdog.join(kernel);
    try {
      assertTrue(kernel.prepared.await(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS));
      assertTrue(kernel.looked.await(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS));
    } finally {
      watchdog.leave(kernel);
    }
  }
}
