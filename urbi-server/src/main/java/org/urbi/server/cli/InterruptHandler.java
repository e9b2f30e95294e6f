package org.urbi.server.cli;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * What {@code Ctrl-C} does (manual, section 21.3.2). In a session the first kills the foreground
 * job, a second one within 1.5 s shuts down, a third one ends the process at once; without a
 * session the first shuts down and the second ends the process.
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
   * Everything that a test wants to see.
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

  /** Listens to the signal of the interrupt key; a terminal session tells of it by itself. */
  void install() {
    Signals.whenInterrupted(this::interrupted);
  }

  /** The interrupt key was hit. */
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
