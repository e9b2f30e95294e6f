package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;

/**
 * A way to hear from the outside on the kernel thread itself, without another thread that has to be
 * woken first. What is heard is {@linkplain Inbox#post posted}, as everything is. All methods but
 * {@link Wait#wake} are called on the kernel thread, between the jobs.
 */
public interface KernelPoller {
  /** There is nothing to hear. */
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
    /** Waits, but not if it was woken since it began. */
    void await();

    /** Ends the waiting; from any thread. */
    void wake();
  }

  /**
   * The kernel has nothing to do for so many nanoseconds.
   *
   * @return how to wait for what can be heard; null if there is nothing
   */
  @Nullable Wait begin(long nanoseconds);

  /** The wait is over: posts what is there. */
  void poll();

  /** The kernel is busy; posts what is there if that was not done for long. */
  void pollIfDue(long now);

  /** The kernel has ended. */
  void close();
}
