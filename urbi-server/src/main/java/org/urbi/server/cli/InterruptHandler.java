package org.urbi.server.cli;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * Handles {@code Ctrl-C} (manual, section 21.3.2). In a session the first interrupt kills the
 * foreground job, a second one within 1.5 s shuts the server down, and a third one ends the process
 * at once. Without a session the first interrupt shuts down and the second ends the process.
 */
final class InterruptHandler {
  private static final int SECOND_WITHIN_MILLISECONDS = 1500;
  private static final int KILLED_BY_INTERRUPT = 130;

  private final BooleanSupplier inSession;
  private final Runnable killForeground;
  private final Runnable shutdown;
  private final Runnable halt;
  private final Executor later;
  private boolean shuttingDown;
  private int recent;

  InterruptHandler(BooleanSupplier inSession, Runnable killForeground, Runnable shutdown) {
    this(
        inSession,
        killForeground,
        shutdown,
        () -> Runtime.getRuntime().halt(KILLED_BY_INTERRUPT),
        CompletableFuture.delayedExecutor(SECOND_WITHIN_MILLISECONDS, TimeUnit.MILLISECONDS));
  }

  /**
   * For tests.
   *
   * @param later runs what it is given once the time for a second interrupt is over
   */
  InterruptHandler(
      BooleanSupplier inSession,
      Runnable killForeground,
      Runnable shutdown,
      Runnable halt,
      Executor later) {
    this.inSession = inSession;
    this.killForeground = killForeground;
    this.shutdown = shutdown;
    this.halt = halt;
    this.later = later;
  }

  /** Registers for the interrupt signal. A terminal session calls {@link #interrupted} itself. */
  void install() {
    Signals.whenInterrupted(this::interrupted);
  }

  /** Handles one interrupt. */
  void interrupted() {
    Runnable reaction;
    synchronized (this) {
      if (shuttingDown) {
        reaction = halt;
      } else if (recent > 0 || !inSession.getAsBoolean()) {
        shuttingDown = true;
        reaction = shutdown;
      } else {
        ++recent;
        later.execute(this::forget);
        reaction = killForeground;
      }
    }
    reaction.run();
  }

  private synchronized void forget() {
    --recent;
  }
}
