package org.urbi.kernel;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.trust.Role;

/** A console that cannot read, as when memory is exhausted. */
class FailingReaderTest {
  @Test
  void whoFailsToReadLetsOthersRun() throws Exception {
    CompletableFuture<Void> over = new CompletableFuture<>();
    Kernel kernel =
        Kernel.builder().virtualTime(true).logLevel(LogLevel.of("NONE")).onHalt(end -> {}).start();
    KernelThread.run(
        kernel,
        () -> {
          Scheduler scheduler = kernel.scheduler();
          Output nowhere = new Output(scheduler, text -> {});
          UrbiLobby lobby =
              UrbiLobby.start(
                  kernel.interpreter(), nowhere, failing(over), Role.USER, new Budget());
          lobby.shell().start();
          scheduler.startDetached(
              lobby, scheduler.rootScope(), "other", job -> lobby.shell().close());
        });
    over.get(TestTimeout.LONG.toMillis(), TimeUnit.MILLISECONDS);
    kernel.requestShutdown(0);
  }

  private static Shell.Listener failing(CompletableFuture<Void> over) {
    return new Shell.Listener() {
      @Override
      public void starving(boolean begins) {
        if (begins) {
          throw new IllegalStateException("as if there was no memory");
        }
      }

      @Override
      public void consumed() {}

      @Override
      public void finished() {
        over.complete(null);
      }
    };
  }
}
