package org.urbi.kernel.library.system;

/** The ways in which a program can end the kernel that runs it. */
public interface ShutdownControl {
  /** Ends the kernel after this tick, with that exit status. */
  void requestShutdown(int status);

  /** Ends the whole program at once, with that exit status; nothing is closed. */
  void halt(int status);

  /** Ends the kernel and starts another one in its place; false when nobody would do that. */
  boolean requestReboot();
}
