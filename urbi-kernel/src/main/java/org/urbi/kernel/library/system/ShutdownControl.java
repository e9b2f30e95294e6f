package org.urbi.kernel.library.system;

/** The ways in which a program can end the kernel that runs it. */
public interface ShutdownControl {
  /** Ends the kernel after this tick, with that exit status. */
  void requestShutdown(int status);

  /** Ends the whole program at once, with that exit status; nothing is closed. */
  void halt(int status);

  /**
   * Ends the kernel so that another one is started in its place; false if nobody would start one.
   */
  boolean requestReboot();
}
