package org.urbi.kernel.job;

import java.util.function.LongSupplier;

/** How the kernel thread waits for those who look after the memory. */
public final class MemoryWait {
  private Runnable relief = () -> {};
  private Runnable look = () -> {};
  private final MemoryGate gate;

  /**
   * @param allocated how many bytes the kernel thread has allocated
   */
  MemoryWait(LongSupplier allocated) {
    gate = new MemoryGate(allocated, this);
  }

  /** What the kernel thread has to pass where memory becomes scarce. */
  public MemoryGate gate() {
    return gate;
  }

  /**
   * Sets what waits until somebody has been asked to give back memory. To be called before the
   * kernel starts.
   */
  public void setRelief(Runnable how) {
    relief = how;
  }

  /**
   * Sets what waits until somebody has looked how much of the memory is garbage. To be called
   * before the kernel starts.
   */
  public void setLook(Runnable how) {
    look = how;
  }

  /** Waits until somebody has looked how much of the memory is garbage. */
  void look() {
    await(look);
  }

  /** Waits until somebody has been asked for memory; whoever runs, nobody else does meanwhile. */
  public void await() {
    await(relief);
  }

  private static void await(Runnable what) {
    try {
      what.run();
    } catch (OutOfMemoryError e) {
      // There is no memory for waiting, either: whoever has caught the first error goes on.
      return;
    }
  }

  /** Waits for memory, if it was a lack of it that the code of a job has failed of. */
  public void recover(Throwable failure) {
    if (failure instanceof OutOfMemoryError) {
      await();
    }
  }
}
