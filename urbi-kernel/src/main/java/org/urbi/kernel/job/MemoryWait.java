package org.urbi.kernel.job;

/** What the kernel thread does where there was no memory for something. */
public final class MemoryWait {
  private Runnable relief = () -> {};

  /**
   * Sets what waits until somebody has been asked to give back memory. To be called before the
   * kernel starts.
   */
  public void setRelief(Runnable how) {
    relief = how;
  }

  /** Waits until somebody has been asked for memory; whoever runs, nobody else does meanwhile. */
  public void await() {
    try {
      KernelThreadPin.pin();
      try {
        relief.run();
      } finally {
        KernelThreadPin.unpin();
      }
    } catch (OutOfMemoryError e) {
      // There is none for waiting, either: whoever has caught the first one goes on.
      return;
    }
  }

  /** The same if that is what the code of a job has failed of. */
  public void recover(Throwable failure) {
    if (failure instanceof OutOfMemoryError) {
      await();
    }
  }
}
