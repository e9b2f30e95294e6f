package urbi.thread;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** What tests wait for: so long that no busy machine is blamed, but not for ever. */
public final class Awaited {
  /** Less than the limit of a test, so that it can say what it has waited for. */
  private static final Duration LONG =
      Duration.ofSeconds(Integer.getInteger("test.limit", 600) / 2);

  private Awaited() {}

  /** What is promised. */
  public static <T> T value(CompletableFuture<T> promise) throws Exception {
    return promise.get(LONG.toSeconds(), TimeUnit.SECONDS);
  }

  /** What happens as often as was counted. */
  public static void zero(CountDownLatch latch) throws InterruptedException {
    if (!latch.await(LONG.toSeconds(), TimeUnit.SECONDS)) {
      throw new AssertionError("still " + latch.getCount() + " to come");
    }
  }

  /** The end of a thread. */
  public static void end(Thread thread) throws InterruptedException {
    if (!thread.join(LONG)) {
      throw new AssertionError(thread + " still runs");
    }
  }
}
