package org.urbi.server.isolated;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.urbi.kernel.log.FailureLog;

/**
 * What happens to a process that takes too long. It must happen also when no thread can be made any
 * more: what lacks then may be the very reason why the process takes so long.
 */
final class TimeLimit {
  private TimeLimit() {}

  /** Does something later, whose end nobody has to wait for. */
  static void after(long milliseconds, Runnable work) {
    CompletableFuture.delayedExecutor(milliseconds, TimeUnit.MILLISECONDS, executor())
        .execute(work);
  }

  private static Executor executor() {
    return work -> execute(work, body -> FailureLog.THREADS.platform("urbi-module-limit", body));
  }

  /**
   * On a thread of its own, because those that the program around the kernel shares may all be
   * blocked; without one on the calling thread, which has the time of all processes.
   *
   * @param maker makes the thread
   */
  static void execute(Runnable work, Function<Runnable, Thread> maker) {
    try {
      maker.apply(work).start();
    } catch (OutOfMemoryError e) {
      FailureLog.internal("the thread urbi-module-limit", e);
      FailureLog.THREADS.guarding("the end of a module's process", work).run();
    }
  }
}
