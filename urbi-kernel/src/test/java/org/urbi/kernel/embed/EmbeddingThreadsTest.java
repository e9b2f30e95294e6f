package org.urbi.kernel.embed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.KernelBuilder;
import org.urbi.kernel.job.JobThreads;

/** Several threads, several kernels, listeners of all sorts, and the end of it all. */
class EmbeddingThreadsTest {
  private static KernelBuilder builder(JobThreads jobThreads) {
    return Kernel.builder().jobThreads(jobThreads).output(text -> {});
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void manyThreadsShareOneKernel(JobThreads jobThreads) throws Exception {
    int threads = 16;
    int rounds = 50;
    try (Kernel kernel = builder(jobThreads).start();
        ExecutorService pool = Executors.newFixedThreadPool(threads)) {
      kernel.eval("var n = 0; function add(x) { n = n + x | n }");
      List<Callable<Void>> tasks = new ArrayList<>();
      for (int thread = 0; thread < threads; thread++) {
        int own = thread;
        tasks.add(() -> {
          for (int i = 0; i < rounds; i++) {
            assertEquals(own + 1.0, kernel.eval(own + "; sleep(0.1ms); " + own + " + 1"));
            kernel.call("add", 1);
            assertThrows(UrbiError.class, () -> kernel.eval("throw 1"));
          }
          return null;
        });
      }
      for (Future<Void> done : pool.invokeAll(tasks)) {
        done.get();
      }
      assertEquals((double) threads * rounds, kernel.eval("n"));
    }
  }

  @Test
  void severalKernelsLiveInOneProcess() {
    List<Kernel> kernels = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      Kernel kernel =
          builder(i % 2 == 0 ? JobThreads.TICK_LOOP : JobThreads.BATON)
              .virtualTime(i % 3 == 0)
              .start();
      kernel.eval("var me = " + i);
      kernels.add(kernel);
    }
    // One kernel may ask another.
    kernels.get(0).define("other", all -> kernels.get(1).eval("sleep(1ms) | me"));
    kernels.get(1).define("other", all -> kernels.get(2).eval("sleep(1ms) | me"));
    assertEquals(1.0, kernels.get(0).eval("other"));
    assertEquals(2.0, kernels.get(1).eval("other"));
    kernels.get(3).close();
    for (int i = 0; i < 6; i++) {
      Kernel kernel = kernels.get(i);
      assertEquals(i != 3, kernel.isRunning());
      if (i != 3) {
        assertEquals((double) i, kernel.eval("me"));
        kernel.close();
      }
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void listenersHearEventsAndChanges(JobThreads jobThreads) throws Exception {
    try (Kernel kernel = builder(jobThreads).start()) {
      BlockingQueue<Object> heard = new LinkedBlockingQueue<>();
      kernel.eval("var e = Event.new; class R { var x = 0 }");
      ListenerRegistration events = kernel.onEvent("e", heard::add);
      kernel.eval("for| (var i : 1000) e!(i, \"é\")");
      for (int i = 0; i < 1000; i++) {
        assertEquals(List.of((double) i, "é"), heard.take());
      }
      ListenerRegistration changes = kernel.onChange("R.x", heard::add);
      kernel.eval("R.x = 1 | R.x = 2");
      assertEquals(1.0, heard.take());
      assertEquals(2.0, heard.take());
      changes.close();
      events.close();
      events.close();
      kernel.eval("R.x = 3 | e!");
      assertEquals(false, kernel.eval("e.hasSubscribers"));
      assertTrue(heard.isEmpty());
      assertThrows(UrbiError.class, () -> kernel.onEvent("1", heard::add));
      assertThrows(UrbiError.class, () -> kernel.onEvent("missing", heard::add));
      assertThrows(UrbiError.class, () -> kernel.onChange("1 +", heard::add));
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void listenersThatFailBlockOrEvaluateHarmNobody(JobThreads jobThreads) throws Exception {
    BlockingQueue<Throwable> failures = new LinkedBlockingQueue<>();
    Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
    Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> failures.add(failure));
    CountDownLatch release = new CountDownLatch(1);
    try (Kernel kernel = builder(jobThreads).start()) {
      kernel.eval("var e = Event.new; var n = 0");
      BlockingQueue<Object> heard = new LinkedBlockingQueue<>();
      ListenerRegistration failing =
          kernel.onEvent(
              "e",
              payload -> {
                throw new IllegalStateException("failing " + payload);
              });
      kernel.onEvent("e", payload -> await(release));
      ListenerRegistration asking =
          kernel.onEvent("e", payload -> heard.add(kernel.eval("n = n + 1 | n")));
      kernel.eval("e!(1)|e!(2)");
      assertEquals("failing [1.0]", failures.take().getMessage());
      assertEquals("failing [2.0]", failures.take().getMessage());
      assertEquals(1.0, heard.take());
      assertEquals(2.0, heard.take());
      failing.close();
      asking.close();
      // More than a blocked listener is given time for.
      kernel.eval("for| (30000) e!");
      assertEquals(1.0, kernel.eval("1"));
      release.countDown();
      String missed = failures.take().getMessage();
      assertTrue(missed.contains("has missed"), missed);
    } finally {
      release.countDown();
      Thread.setDefaultUncaughtExceptionHandler(before);
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void theEndFailsWhatPends(JobThreads jobThreads) throws Exception {
    Kernel kernel = builder(jobThreads).start();
    UrbiValue object = kernel.eval("Object.new", UrbiValue.class);
    List<CompletableFuture<Object>> pending = new ArrayList<>();
    for (int i = 0; i < 10; i++) {
      pending.add(kernel.evalAsync("sleep"));
      pending.add(kernel.evalAsync("loop {}"));
    }
    CompletableFuture<Object> waiting =
        CompletableFuture.supplyAsync(() -> kernel.eval("sleep"), task -> new Thread(task).start());
    pending.add(kernel.evalAsync("1"));
    pending.removeLast().join();
    kernel.close();
    for (CompletableFuture<Object> future : pending) {
      assertEnded(assertThrows(CompletionException.class, future::join).getCause());
    }
    assertEnded(assertThrows(CompletionException.class, waiting::join).getCause());
    assertEnded(assertThrows(IllegalStateException.class, () -> kernel.eval("1")));
    assertEnded(assertThrows(IllegalStateException.class, () -> kernel.call("f")));
    assertEnded(assertThrows(IllegalStateException.class, () -> kernel.onEvent("e", e -> {})));
    assertEnded(assertThrows(IllegalStateException.class, () -> object.get("x")));
    assertTrue(object.toString().contains("ended"));
    assertTrue(kernel.evalAsync("1").handle((v, e) -> e != null).join());
    kernel.close();
    assertFalse(kernel.isRunning());
  }

  private static void assertEnded(Throwable failure) {
    assertEquals(IllegalStateException.class, failure.getClass());
    assertEquals("the kernel has ended", failure.getMessage());
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void closingRacesWithEvaluating(JobThreads jobThreads) throws Exception {
    for (int round = 0; round < 20; round++) {
      Kernel kernel = builder(jobThreads).start();
      CountDownLatch begun = new CountDownLatch(4);
      List<CompletableFuture<Void>> users = new ArrayList<>();
      for (int i = 0; i < 4; i++) {
        users.add(
            CompletableFuture.runAsync(
                () -> {
                  begun.countDown();
                  try {
                    while (true) {
                      assertEquals(2.0, kernel.eval("1 + 1"));
                    }
                  } catch (IllegalStateException end) {
                    assertEnded(end);
                  }
                },
                task -> new Thread(task).start()));
      }
      begun.await();
      kernel.close();
      users.forEach(CompletableFuture::join);
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void codeThatNeverLetsOthersRunDoesNotPreventTheEnd(JobThreads jobThreads) throws Exception {
    Kernel kernel = builder(jobThreads).start();
    CountDownLatch spinning = new CountDownLatch(1);
    kernel.define(
        "spinning",
        all -> {
          spinning.countDown();
          return null;
        });
    CompletableFuture<Object> spin = kernel.evalAsync("spinning; while| (true) {}");
    spinning.await();
    kernel.close();
    assertEnded(assertThrows(CompletionException.class, spin::join).getCause());
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void whatIsNoLongerWantedIsStopped(JobThreads jobThreads) throws Exception {
    try (Kernel kernel = builder(jobThreads).start()) {
      BlockingQueue<Object> stopped = new LinkedBlockingQueue<>();
      kernel.define("stopped", stopped::add);
      CompletableFuture<Object> asleep = kernel.evalAsync("try { sleep } finally { stopped(1) }");
      kernel.eval("1");
      asleep.cancel(true);
      assertEquals(List.of(1.0), stopped.take());

      CompletableFuture<Boolean> interrupted = new CompletableFuture<>();
      Thread waiting =
          new Thread(() -> {
            assertThrows(
                CancellationException.class,
                () -> kernel.eval("try { sleep } finally { stopped(2) }"));
            interrupted.complete(Thread.currentThread().isInterrupted());
          });
      waiting.start();
      waiting.interrupt();
      assertTrue(interrupted.join());
      assertEquals(1.0, kernel.eval("1"));
    }
  }

  @Test
  void anOutputThatFailsOrBlocksHarmsNobody() throws Exception {
    CountDownLatch release = new CountDownLatch(1);
    try (Kernel kernel = Kernel.builder().output(text -> await(release)).start()) {
      assertEquals(3.0, kernel.eval("echo(1) | 3"));
    } finally {
      release.countDown();
    }
    BlockingQueue<Object> heard = new LinkedBlockingQueue<>();
    Kernel[] own = new Kernel[1];
    try (Kernel kernel = Kernel.builder().output(text -> heard.add(own[0].eval("2 + 3"))).start()) {
      own[0] = kernel;
      kernel.eval("echo(1)");
      assertEquals(5.0, heard.take());
    }
  }
}
