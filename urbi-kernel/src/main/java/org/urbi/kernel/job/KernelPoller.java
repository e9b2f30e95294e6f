package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;

/**
 * Receives data from outside on the kernel thread itself, which saves waking another thread first.
 * What it receives is {@linkplain Inbox#post posted} like all other messages. All methods except
 * {@link Wait#wake} are called on the kernel thread, between the jobs.
 */
public interface KernelPoller {
  /** Polls nothing. */
  KernelPoller NONE =
      new KernelPoller() {
        @Override
        public @Nullable Wait begin(long nanoseconds) {
          return null;
        }

        @Override
        public void poll() {}

        @Override
        public void pollIfDue(long now) {}

        @Override
        public void close() {}
      };

  /** A wait that another thread can end. */
  interface Wait {
    /** Waits; returns at once if {@link #wake} was called since the wait began. */
    void await();

    /** Ends the waiting; from any thread. */
    void wake();
  }

  /**
   * The kernel has nothing to do for that many nanoseconds.
   *
   * @return a way to wait for data; null if none can arrive
   */
  @Nullable Wait begin(long nanoseconds);

  /** The wait is over: posts what has arrived. */
  void poll();

  /** The kernel is busy: posts what has arrived, unless that was done recently. */
  void pollIfDue(long now);

  /** The kernel has ended. */
  void close();
}
