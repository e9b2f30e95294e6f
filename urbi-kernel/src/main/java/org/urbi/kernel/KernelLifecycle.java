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
import org.urbi.kernel.library.system.ShutdownControl;
import org.urbi.kernel.message.Message;

/** Whether a kernel runs, and how it ends. */
final class KernelLifecycle implements ShutdownControl {
  /** How long jobs may take to end when the kernel is closed, before they are interrupted. */
  private static final int END_TIMEOUT_MILLISECONDS = 100;

  /** The exit status of a kernel that has ended because of a bug of ours (EX_SOFTWARE). */
  private static final int BROKEN = 70;

  private final Scheduler scheduler;
  private final Runnable lastLook;
  private final Runnable farewell;
  private final @Nullable IntConsumer onHalt;
  private final @Nullable Runnable onReboot;
  private final List<Runnable> onTermination = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Integer> termination = new CompletableFuture<>();
  private int status;
  private boolean stopping;

  /**
   * @param lastLook called on the kernel thread when the kernel is about to end, before that, or
   *     the process is about to be halted
   * @param farewell called on the kernel thread when the kernel is about to end
   * @param onHalt ends the process at once; null if only the kernel is to end
   * @param onReboot called before the kernel ends in order to be restarted; null if nobody would
   *     restart it
   */
  KernelLifecycle(
      Scheduler scheduler,
      Runnable lastLook,
      Runnable farewell,
      @Nullable IntConsumer onHalt,
      @Nullable Runnable onReboot) {
    this.scheduler = scheduler;
    this.lastLook = lastLook;
    this.farewell = farewell;
    this.onHalt = onHalt;
    this.onReboot = onReboot;
  }

  // ------------------------------------------------------------------ its end is wanted

  /**
   * Somebody outside wants its end; from any thread. Clients call that on the kernel thread, too: a
   * replay has them not, so it must hear of it.
   */
  void wishShutdown(int exitStatus) {
    scheduler.inbox().post(new Message.Shutdown(exitStatus));
  }

  /** Ends the kernel after this tick; on the kernel thread. */
  @Override
  public void requestShutdown(int exitStatus) {
    if (!stopping) {
      stopping = true;
      status = exitStatus;
      lastLook.run();
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
      lastLook.run();
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
   * Completes the waits for the end of the kernel.
   *
   * @param failure what ended it; null for a regular end
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

  /** Gives code that holds the kernel a moment to end by itself, then interrupts it. */
  void interruptUnlessEnded() {
    try {
      termination.get(END_TIMEOUT_MILLISECONDS, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      scheduler.interruptions().requestAll();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      scheduler.interruptions().requestAll();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }
}
