package org.urbi.kernel;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.library.system.KernelEnd;
import org.urbi.kernel.message.Message;

/** Whether a kernel runs, and how it ends. */
final class KernelLife implements KernelEnd {
  /** How long the jobs have to end in when the kernel is closed, before they are interrupted. */
  private static final int END_PATIENCE_MILLISECONDS = 100;

  /** The exit status of a kernel that a fault of its own has ended. */
  private static final int BROKEN = 70;

  private final Scheduler scheduler;
  private final Runnable farewell;
  private final @Nullable IntConsumer onHalt;
  private final @Nullable Runnable onReboot;
  private final List<Runnable> onTermination = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Integer> termination = new CompletableFuture<>();
  private int status;
  private boolean stopping;

  /**
   * @param farewell told on the kernel thread that the kernel is to end
   * @param onHalt what ends the process at once; null when only the kernel is to end
   * @param onReboot told before the kernel ends to be started anew; null when nobody would do that
   */
  KernelLife(
      Scheduler scheduler,
      Runnable farewell,
      @Nullable IntConsumer onHalt,
      @Nullable Runnable onReboot) {
    this.scheduler = scheduler;
    this.farewell = farewell;
    this.onHalt = onHalt;
    this.onReboot = onReboot;
  }

  // ------------------------------------------------------------------ its end is wanted

  /** Ends the kernel after this tick; from any thread. */
  @Override
  public void requestShutdown(int exitStatus) {
    if (scheduler.isKernelThread()) {
      shutDown(exitStatus);
    } else {
      scheduler.inbox().post(new Message.Shutdown(exitStatus));
    }
  }

  /** Ends the kernel after this tick; on the kernel thread. */
  void shutDown(int exitStatus) {
    if (!stopping) {
      stopping = true;
      status = exitStatus;
      farewell.run();
      scheduler.stop();
    }
  }

  @Override
  public void halt(int exitStatus) {
    scheduler.journal().end();
    if (onHalt == null) {
      requestShutdown(exitStatus);
    } else {
      onHalt.accept(exitStatus);
    }
  }

  @Override
  public boolean requestReboot() {
    if (onReboot == null) {
      return false;
    }
    onReboot.run();
    requestShutdown(0);
    return true;
  }

  boolean isStopping() {
    return stopping;
  }

  // ------------------------------------------------------------------ it has ended

  /** Runs something when the kernel has ended. */
  void onTermination(Runnable action) {
    onTermination.add(action);
  }

  /**
   * Tells those who wait that the kernel has ended.
   *
   * @param failure by which; null when it was meant to
   */
  void ended(Throwable failure) {
    if (failure != null) {
      status = BROKEN;
    }
    try {
      onTermination.forEach(Runnable::run);
    } finally {
      termination.complete(status);
    }
  }

  boolean hasEnded() {
    return termination.isDone();
  }

  /** Waits for the end, and returns the exit status. */
  int await() {
    return termination.join();
  }

  /** Code that holds the kernel has a moment to come to its end. */
  void interruptUnlessEnded() {
    try {
      termination.get(END_PATIENCE_MILLISECONDS, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      scheduler.interruptions().wantAll();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      scheduler.interruptions().wantAll();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }
}
