package org.urbi.server.studio;

import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import org.urbi.kernel.log.FailureLog;

/**
 * Does for browsers what takes its time, one thing after the other, on a thread of its own: neither
 * the kernel nor the network waits for it.
 */
final class Worker implements AutoCloseable {
  /** Enough for the parser, which is recursive. */
  private static final long STACK_BYTES = 1 << 24;

  private final ExecutorService thread;

  Worker(String name) {
    thread = FailureLog.THREADS.single(name, STACK_BYTES);
  }

  /**
   * Does something.
   *
   * @return its result; done exceptionally, by what it has thrown, or if nobody is served any more
   */
  <T> CompletableFuture<T> ask(Callable<T> work) {
    CompletableFuture<T> result = new CompletableFuture<>();
    try {
      thread.execute(() -> {
        try {
          result.complete(work.call());
        } catch (Throwable e) {
          result.completeExceptionally(e);
        }
      });
    } catch (RejectedExecutionException e) {
      result.completeExceptionally(e);
    }
    return result;
  }

  @Override
  public void close() {
    thread.shutdownNow();
  }
}
