package org.urbi.server.cli;

import java.util.function.BooleanSupplier;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;

/**
 * Handles {@code Ctrl-C} (manual, section 21.3.2). In a session the first interrupt kills the
 * foreground job, a second one within 1.5 s shuts the server down, and a third one ends the process
 * at once. Without a session the first interrupt shuts down and the second ends the process.
 */
final class InterruptHandler {
  /** In nanoseconds. A timer would be late on a busy machine, and a later interrupt the second. */
  private static final long SECOND_WITHIN = 1_500_000_000;

  private static final int KILLED_BY_INTERRUPT = 130;

  private final BooleanSupplier inSession;
  private final Runnable killForeground;
  private final Runnable shutdown;
  private final Runnable halt;
  private final Clock clock;
  private boolean shuttingDown;
  private boolean interrupted;
  private long interruptedAt;

  InterruptHandler(BooleanSupplier inSession, Runnable killForeground, Runnable shutdown) {
    this(
        inSession,
        killForeground,
        shutdown,
        () -> Runtime.getRuntime().halt(KILLED_BY_INTERRUPT),
        new SystemClock());
  }

  /** For tests. */
  InterruptHandler(
      BooleanSupplier inSession,
      Runnable killForeground,
      Runnable shutdown,
      Runnable halt,
      Clock clock) {
    this.inSession = inSession;
    this.killForeground = killForeground;
    this.shutdown = shutdown;
    this.halt = halt;
    this.clock = clock;
  }

  /**
   * Registers for the interrupt signal. An editor, where it is a key, calls {@link #interrupted}.
   */
  void install() {
    Signals.whenInterrupted(this::interrupted);
  }

  /** Handles one interrupt. */
  void interrupted() {
    Runnable reaction;
    synchronized (this) {
      long now = clock.now();
      if (shuttingDown) {
        reaction = halt;
      } else if (interrupted && now - interruptedAt < SECOND_WITHIN || !inSession.getAsBoolean()) {
        shuttingDown = true;
        reaction = shutdown;
      } else {
        interrupted = true;
        interruptedAt = now;
        reaction = killForeground;
      }
    }
    reaction.run();
  }
}
