package org.urbi.kernel.job;

/**
 * A way to wait for news without another thread that passes them on. On the kernel thread; what is
 * heard goes through the inbox, as everything does.
 */
public interface Listening {
  /**
   * The kernel has nothing to do: waits for news and for the inbox, for at most so many
   * nanoseconds.
   *
   * @return false if it has not waited
   */
  boolean await(long nanoseconds);

  /** The kernel is busy; looks for news if that was not done for long. */
  void glance(long now);

  /** The kernel has ended. */
  void end();
}
