package org.urbi.kernel.job;

/** The two ways to run jobs on virtual threads; both run them in the same order. */
public enum JobThreads {
  /** {@link #TICK_LOOP} when {@code java.lang} is open to us, {@link #BATON} otherwise. */
  AUTO,

  /** The tick loop is the executor of the virtual threads: fastest, wants {@code --add-opens}. */
  TICK_LOOP,

  /** Jobs run on the scheduler of the JDK, and pass control from hand to hand. */
  BATON;

  JobThread.Factory factory(Inbox inbox) {
    return switch (this) {
      case AUTO ->
          TickLoopThread.isAvailable()
              ? new TickLoopThread.Factory(inbox)
              : new HandoffThread.Factory();
      case TICK_LOOP -> new TickLoopThread.Factory(inbox);
      case BATON -> new HandoffThread.Factory();
    };
  }
}
