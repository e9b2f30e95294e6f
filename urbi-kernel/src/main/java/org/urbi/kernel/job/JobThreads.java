package org.urbi.kernel.job;

/** The two ways to run jobs on virtual threads; both run them in the same order. */
public enum JobThreads {
  /** {@link #TICK_LOOP} if {@code java.lang} is opened to the kernel, {@link #BATON} otherwise. */
  AUTO,

  /**
   * The tick loop is the executor of the virtual threads: the fastest way, but needs {@code
   * --add-opens}.
   */
  TICK_LOOP,

  /** Jobs run on the scheduler of the JDK, and hand control to each other. */
  BATON;

  JobThread.Factory factory() {
    return switch (this) {
      case AUTO ->
          TickLoopThread.isAvailable() ? new TickLoopThread.Factory() : new HandoffThread.Factory();
      case TICK_LOOP -> new TickLoopThread.Factory();
      case BATON -> new HandoffThread.Factory();
    };
  }
}
