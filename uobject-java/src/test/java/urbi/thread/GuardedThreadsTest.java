package urbi.thread;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** What becomes of an {@code Error} in a thread. */
class GuardedThreadsTest {
  private static final NoClassDefFoundError DEFECT = new NoClassDefFoundError("lost");

  private final List<String> logged = new CopyOnWriteArrayList<>();
  private final GuardedThreads threads =
      new GuardedThreads((where, failure) -> logged.add(where + " <- " + failure.getMessage()));

  private static void fail() {
    throw DEFECT;
  }

  @Test
  void isLoggedAndThenToldToWhoDependsOnTheThread() throws Exception {
    for (boolean virtual : new boolean[] {false, true}) {
      logged.clear();
      var told = new CompletableFuture<Throwable>();
      Thread made =
          virtual
              ? threads.virtual("of-test", GuardedThreadsTest::fail, told::complete)
              : threads.platform("of-test", GuardedThreadsTest::fail, told::complete);
      assertTrue(made.isDaemon());
      assertEquals("of-test", made.getName());
      made.start();
      assertEquals(DEFECT, Awaited.value(told));
      assertEquals(List.of("the thread of-test <- lost"), logged);
    }
  }

  @Test
  void isToldEvenIfTheLogFails() {
    var broken =
        new GuardedThreads((where, failure) -> {
          throw new OutOfMemoryError("of the log");
        });
    var told = new CompletableFuture<Throwable>();
    Runnable guarded = broken.guarding("a test", GuardedThreadsTest::fail, told::complete);
    try {
      guarded.run();
    } catch (OutOfMemoryError e) {
      assertEquals("of the log", e.getMessage());
    }
    assertEquals(DEFECT, told.getNow(null));
  }

  @Test
  void doesNotEndPeriodicTasks() throws Exception {
    ScheduledExecutorService clock = threads.clock("of-test");
    try {
      var runs = new CountDownLatch(2);
      Runnable task =
          () -> {
            runs.countDown();
            fail();
          };
      clock.scheduleAtFixedRate(task, 0, 1, TimeUnit.MICROSECONDS);
      Awaited.zero(runs);
      assertEquals("the thread of-test <- lost", logged.getFirst());
    } finally {
      clock.shutdownNow();
    }
  }

  @Test
  void isLoggedByExecutorsAndByTasksThatWait() throws Exception {
    var numbers = new AtomicInteger();
    var all = new CountDownLatch(3);
    var counted =
        new GuardedThreads((where, failure) -> {
          logged.add(where + " <- " + failure.getMessage());
          all.countDown();
        });
    try (ExecutorService pool = counted.pool("of-test-", Duration.ZERO)) {
      pool.execute(GuardedThreadsTest::fail);
    }
    try (ExecutorService single = counted.single("of-test-single", 1 << 20)) {
      single.execute(GuardedThreadsTest::fail);
      single.execute(numbers::incrementAndGet);
    }
    try (ExecutorService clock = counted.clock("of-test-clock")) {
      clock.execute(GuardedThreadsTest::fail);
    }
    assertEquals(1, numbers.get());
    // An executor has ended before its last thread has logged what it died of.
    Awaited.zero(all);
    assertEquals(
        Set.of(
            "the thread of-test-0 <- lost",
            "the thread of-test-single <- lost",
            "the thread of-test-clock <- lost"),
        Set.copyOf(logged));
  }

  @Test
  void ofComponentsGoesToTheLogOfTheProcess() {
    try (var log = new LoggedDefects()) {
      GuardedThreads.SDK.guarding("a test", GuardedThreadsTest::fail).run();
      assertEquals(List.of("internal error in a test <- " + DEFECT), log.texts());
    }
  }
}
