package org.urbi.ros;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** What tests wait for: so long that no busy machine is blamed, but not for ever. */
public final class Awaited {
  /** Less than the limit of a test, so that it can say what it has waited for. */
  private static final int SECONDS = Integer.getInteger("test.limit", 600) / 2;

  /** The same, for a socket. */
  public static final int MILLISECONDS = (int) TimeUnit.SECONDS.toMillis(SECONDS);

  private Awaited() {}

  /** The next one of a queue. */
  public static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
    return next(queue, "nothing");
  }

  /** The next one of a queue; if none comes, {@code seen} is told. */
  public static <T> T next(BlockingQueue<T> queue, Object seen) throws InterruptedException {
    T next = queue.poll(SECONDS, TimeUnit.SECONDS);
    if (next == null) {
      throw new AssertionError("nothing within " + SECONDS + " s; seen so far: " + seen);
    }
    return next;
  }

  /** What is promised; throws what {@link CompletableFuture#join} throws. */
  public static <T> T value(CompletableFuture<T> promise) {
    CountDownLatch done = new CountDownLatch(1);
    promise.whenComplete((value, failure) -> done.countDown());
    try {
      zero(done, "nothing");
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
    return promise.join();
  }

  /** Waits until a count is zero; {@code without} tells what there is as long as it is not. */
  public static void zero(CountDownLatch count, String without) throws InterruptedException {
    if (!count.await(SECONDS, TimeUnit.SECONDS)) {
      throw new AssertionError(without + " within " + SECONDS + " s");
    }
  }

  /** Waits until that holds: of programs that tell nobody when it does. */
  public static void until(String what, Callable<Boolean> holds) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(SECONDS);
    while (!holds.call()) {
      if (System.nanoTime() - end > 0) {
        throw new AssertionError("not within " + SECONDS + " s: " + what);
      }
      Thread.sleep(10);
    }
  }
}
