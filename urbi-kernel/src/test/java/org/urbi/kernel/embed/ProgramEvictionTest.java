package org.urbi.kernel.embed;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.TestTimeout;
import org.urbi.kernel.job.JobThreads;
import org.urbi.kernel.job.Scheduler;

/** What a program asks for while others decide that it has to give back memory. */
@ParameterizedClass
@EnumSource(names = {"TICK_LOOP", "BATON"})
class ProgramEvictionTest {
  private static final String WHY = "memory exhausted";

  private final JobThreads jobThreads;
  private final StringBuffer output = new StringBuffer();
  private final CountDownLatch begun = new CountDownLatch(1);
  private final CountDownLatch told = new CountDownLatch(1);
  private Kernel kernel;
  private Scheduler scheduler;

  ProgramEvictionTest(JobThreads jobThreads) {
    this.jobThreads = jobThreads;
  }

  @BeforeEach
  void start() {
    kernel = Kernel.builder().jobThreads(jobThreads).output(output::append).start();
    scheduler = kernel.embedding().scheduler();
  }

  @AfterEach
  void stop() {
    told.countDown();
    kernel.close();
  }

  private static void await(CountDownLatch latch) {
    try {
      assertTrue(latch.await(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS));
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private void define(String name, Runnable body) {
    kernel.define(
        name,
        arguments -> {
          body.run();
          return null;
        });
  }

  /** The thread that decides gets no turn before the program has asked for something else. */
  @Test
  void whatBeginsAfterTheDecisionGoesOn() {
    AtomicInteger asked = new AtomicInteger();
    AtomicReference<CompletableFuture<Object>> innocent = new AtomicReference<>();
    ProgramEviction slow =
        new ProgramEviction(
            scheduler,
            () -> {
              if (asked.getAndIncrement() == 0) {
                innocent.set(
                    kernel.evalAsync(
                        "try { sleep(inf) } finally { echo(\"innocent\") }, hold|"
                            + " for| (3) 1| sleep(1ms)| 1 + 1"));
                await(begun);
              }
              return kernel.embedding().own();
            });
    define("begin", () -> slow.begins(requireNonNull(scheduler.running())));
    define(
        "hold",
        () -> {
          begun.countDown();
          await(told);
        });
    kernel.eval("begin| try { sleep(inf) } finally { echo(\"guilty\") },");
    slow.evict(WHY);
    told.countDown();
    assertEquals(2.0, innocent.get().join());
    kernel.eval("");
    assertTrue(output.toString().contains("guilty"), output.toString());
    assertFalse(output.toString().contains("innocent"), output.toString());
  }

  @Test
  void whatHasBegunIsEndedAndToldWhy() {
    define("begin", begun::countDown);
    kernel.eval("try { sleep(inf) } finally { echo(\"what was left\") },");
    CompletableFuture<Object> asleep = kernel.evalAsync("sleep(inf)");
    CompletableFuture<Object> busy = kernel.evalAsync("begin| while| (true) {}");
    await(begun);
    kernel.embedding().evictable().evict(WHY);
    for (CompletableFuture<Object> each : List.of(asleep, busy)) {
      Throwable why = assertThrows(CompletionException.class, each::join).getCause();
      assertEquals(WHY, assertInstanceOf(UrbiError.class, why).getMessage());
    }
    assertEquals(2.0, kernel.eval("1 + 1"));
    assertTrue(output.toString().contains("what was left"), output.toString());
    assertTrue(output.toString().contains("memory exhausted"), output.toString());
  }

  /** Whoever decides meanwhile means what has failed, and not what the program asks for next. */
  @Test
  void whoGotNoMemoryIsAnsweredWhenThatWasLookedAt() {
    AtomicInteger looks = new AtomicInteger();
    define(
        "fail",
        () -> {
          scheduler.memory().setRelief(looks::incrementAndGet);
          throw new OutOfMemoryError("for a test");
        });
    UrbiError error = assertThrows(UrbiError.class, () -> kernel.eval("fail"));
    assertEquals(WHY, error.getMessage());
    assertEquals(1, looks.get());
  }
}
