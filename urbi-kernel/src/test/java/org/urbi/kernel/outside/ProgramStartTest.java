package org.urbi.kernel.outside;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.TestTimeout;
import org.urbi.kernel.job.JobThreads;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.World;
import org.urbi.kernel.time.SystemClock;

/** Programs that nobody wants any more when they are there. */
class ProgramStartTest {
  private final CountDownLatch begun = new CountDownLatch(1);
  private final CountDownLatch mayGoOn = new CountDownLatch(1);
  private final CompletableFuture<Process> started = new CompletableFuture<>();
  private final Outside outside =
      new Outside(
          new Scheduler(
              new World(),
              new SystemClock(),
              Journal.NONE,
              JobThreads.AUTO,
              (job, failure) -> started.completeExceptionally(failure)),
          Confinement.none(),
          Confinement.none());

  private ProgramStart slowly() {
    return ProgramStart.of(
        outside,
        () -> {
          begun.countDown();
          mayGoOn.await();
          Process made = new ProcessBuilder("sleep", "1000").start();
          started.complete(made);
          return made;
        });
  }

  private void assertKilled() throws Exception {
    assertTrue(started.get().waitFor(TestTimeout.LONG), "it goes on");
  }

  @Test
  void whoIsEndedMeanwhileLeavesNoProgram() throws Exception {
    ProgramStart start = slowly();
    Thread starting = Thread.ofPlatform().start(() -> callIt(start));
    begun.await();
    start.abandon();
    mayGoOn.countDown();
    assertKilled();
    starting.join();
  }

  @Test
  void aKernelThatEndsMeanwhileWaitsForIt() throws Exception {
    ProgramStart start = slowly();
    Thread starting = Thread.ofPlatform().start(() -> callIt(start));
    begun.await();
    Thread ending = Thread.ofPlatform().start(outside::close);
    mayGoOn.countDown();
    ending.join();
    assertKilled();
    starting.join();
  }

  @Test
  void whatNobodyWantsIsNotStarted() {
    ProgramStart start = slowly();
    start.abandon();
    assertThrows(IOException.class, start::call);
  }

  private static void callIt(ProgramStart start) {
    try {
      start.call();
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }
}
