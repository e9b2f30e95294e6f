package org.urbi.kernel.uobject;

import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.function.Function;
import java.util.function.Supplier;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;

/** What other threads want done on the kernel thread: each becomes a job, and the thread waits. */
final class KernelRequests {
  private final Interpreter interpreter;
  private final Set<CompletableFuture<?>> pending = ConcurrentHashMap.newKeySet();
  private volatile boolean over;

  KernelRequests(Interpreter interpreter) {
    this.interpreter = interpreter;
  }

  /**
   * Has something done by a job, and waits.
   *
   * @throws IllegalStateException if the kernel has ended
   * @throws CancellationException if the thread is interrupted
   */
  <T> T ask(Supplier<UrbiObject> lobby, Function<Frame, T> task) {
    CompletableFuture<T> future = new CompletableFuture<>();
    pending.add(future);
    try {
      interpreter.scheduler().inbox().post(() -> start(lobby.get(), task, future));
      if (over) {
        throw ended();
      }
      return future.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException("interrupted while waiting for the kernel");
    } catch (ExecutionException e) {
      throw switch (e.getCause()) {
        case RuntimeException failure -> failure;
        case Throwable other -> new IllegalStateException(other);
      };
    } finally {
      pending.remove(future);
    }
  }

  private <T> void start(UrbiObject lobby, Function<Frame, T> task, CompletableFuture<T> future) {
    Scheduler scheduler = interpreter.scheduler();
    scheduler
        .startDetached(
            lobby,
            scheduler.rootScope(),
            "uobject",
            job -> {
              try {
                future.complete(task.apply(Frame.top(interpreter, job, lobby, new FrameLayout())));
              } catch (RuntimeException | Error e) {
                future.completeExceptionally(e);
              }
            })
        .onEnd(() -> future.completeExceptionally(new CancellationException("stopped")));
  }

  private static IllegalStateException ended() {
    return new IllegalStateException("the kernel has ended");
  }

  /** The kernel has ended: nobody waits any longer. */
  void close() {
    over = true;
    pending.forEach(future -> future.completeExceptionally(ended()));
  }
}
