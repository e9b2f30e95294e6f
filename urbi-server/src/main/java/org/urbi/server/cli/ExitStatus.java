package org.urbi.server.cli;

/** The exit statuses of a server that does not end by itself (docs/robustness.md). */
final class ExitStatus {
  /** Its output could not be written: nobody reads it, or the disk is full. */
  static final int OUTPUT_LOST = 74;

  /** The kernel or the network did not turn any more. */
  static final int STUCK = 70;

  /** Memory could not be freed. */
  static final int MEMORY_EXHAUSTED = 71;

  /** It was told to terminate (SIGTERM). */
  static final int TERMINATED = 143;

  private ExitStatus() {}
}
