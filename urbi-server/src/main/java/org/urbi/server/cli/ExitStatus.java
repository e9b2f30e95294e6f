package org.urbi.server.cli;

import org.urbi.server.options.Program;

/** The exit statuses of a server that was ended by a fault or a signal (docs/robustness.md). */
final class ExitStatus {
  /** The output could not be written, as with all programs. */
  static final int OUTPUT_LOST = Program.OUTPUT_LOST;

  /** The kernel thread or the network thread was blocked. */
  static final int STUCK = 70;

  /** Memory could not be freed. */
  static final int MEMORY_EXHAUSTED = 71;

  /** The process received SIGTERM. */
  static final int TERMINATED = 143;

  private ExitStatus() {}
}
