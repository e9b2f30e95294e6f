package org.urbi.kernel.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** The thread of native code fails: who waits for a call is told, and the kernel is not held. */
class NativeThreadTest {
  private final Error defect = new AssertionError("as if there was no memory");
  private int made;
  private @Nullable Consumer<Throwable> failed;

  private final NativeThread healthy = with((body, told) -> body);

  /** What a thread executes instead of its body; only the first thread. */
  private interface Fault {
    Runnable in(Runnable body, Consumer<Throwable> failed);
  }

  private NativeThread with(Fault fault) {
    return new NativeThread(
        null,
        (body, told) -> {
          failed = told;
          Runnable executed = made++ == 0 ? fault.in(body, told) : body;
          return Thread.ofPlatform().daemon().unstarted(executed);
        });
  }

  /** As if the thread had ended in the middle of a call. */
  private Object endsTheThread() {
    failed.accept(defect);
    try {
      new CountDownLatch(1).await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return "never";
  }

  private void failsWithTheDefect(NativeThread thread, Supplier<Object> code) {
    assertSame(defect, assertThrows(Error.class, () -> thread.execute(code)));
  }

  private void works(NativeThread thread) {
    assertEquals("done", thread.execute(() -> thread.ask(() -> "done")));
  }

  @Test
  void ifItCannotBeStartedTheNextCallTriesAgain() {
    NativeThread thread =
        new NativeThread(
            null,
            (body, told) ->
                made++ == 0
                    ? new Thread() {
                      @Override
                      public void start() {
                        throw defect;
                      }
                    }
                    : Thread.ofPlatform().daemon().unstarted(body));
    failsWithTheDefect(thread, () -> "never");
    works(thread);
    assertEquals(2, made);
  }

  @Test
  void ifItEndsTheCallFailsAndTheNextOneHasAnotherThread() {
    NativeThread thread = with((body, told) -> () -> told.accept(defect));
    failsWithTheDefect(thread, () -> "never");
    works(thread);
    works(thread);
    assertEquals(2, made);
  }

  @Test
  void callsBelowTheOneThatFailsFailToo() {
    failsWithTheDefect(
        healthy,
        () ->
            healthy.ask(() -> {
              failsWithTheDefect(healthy, this::endsTheThread);
              failsWithTheDefect(healthy, () -> "on top of what has ended");
              return "not for anybody";
            }));
    works(healthy);
    assertEquals(2, made);
  }
}
