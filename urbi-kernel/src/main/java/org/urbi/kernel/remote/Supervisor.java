package org.urbi.kernel.remote;

/** Who has started the process, for a module that is isolated. */
interface Supervisor {
  /** The connection is lost; called on any thread. */
  void disconnected(String why);

  /**
   * The process tells of its module; on the kernel thread.
   *
   * @param problem empty when its classes can be used; otherwise why they cannot
   */
  void told(String problem);

  /** Whether nobody wants the process to end; on the kernel thread. */
  boolean isMissed();

  /** The process has ended, and its objects with it; on the kernel thread. */
  void ended(String why);
}
