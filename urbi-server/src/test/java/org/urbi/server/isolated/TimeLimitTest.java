package org.urbi.server.isolated;

import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

/** The limit of a process ends it on whatever thread there is. */
class TimeLimitTest {
  private final CompletableFuture<Thread> on = new CompletableFuture<>();

  private void work() {
    on.complete(Thread.currentThread());
  }

  /** A thread that the system does not give. */
  private static final class NoThread extends Thread {
    @Override
    public void start() {
      throw new OutOfMemoryError("unable to create native thread");
    }
  }

  @Test
  void itHasAThreadOfItsOwn() {
    TimeLimit.execute(this::work, Thread::new);
    assertNotSame(Thread.currentThread(), on.join());
  }

  @Test
  void withoutOneItDoesWithTheThreadThatIsThere() {
    TimeLimit.execute(this::work, work -> new NoThread());
    assertSame(Thread.currentThread(), on.getNow(null));
  }

  /** What fails there must not take the limits of other processes along. */
  @Test
  void whatFailsThereIsLogged() {
    TimeLimit.execute(
        () -> {
          work();
          throw new IllegalStateException("a defect of the test");
        },
        work -> new NoThread());
    assertSame(Thread.currentThread(), on.getNow(null));
  }
}
