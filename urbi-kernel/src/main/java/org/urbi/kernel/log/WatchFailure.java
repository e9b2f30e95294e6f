package org.urbi.kernel.log;

/**
 * What a thread that watches others has met. It goes on in any case, and would meet the same again
 * and again: the first is logged, unless it says that there is no memory to tell anybody.
 */
public final class WatchFailure {
  private final String where;
  private boolean told;

  /**
   * @param where the part of the kernel that watches
   */
  public WatchFailure(String where) {
    this.where = where;
  }

  /** Logs it if it is the first; for the watching thread alone. */
  public void met(Throwable failure) {
    if (!told && !(failure instanceof VirtualMachineError)) {
      told = true;
      try {
        FailureLog.internal(where, failure);
      } catch (RuntimeException | Error e) {
        // Memory may be full since then; the next time there may be some to tell it.
        told = false;
      }
    }
  }
}
