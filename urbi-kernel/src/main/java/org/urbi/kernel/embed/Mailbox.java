package org.urbi.kernel.embed;

import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.log.FailureLog;

/**
 * What the kernel has to say to one listener: handed over one by one, in order, on a thread that is
 * not the kernel's. A listener that blocks holds up nobody but itself; what it throws goes to the
 * log, and to the {@linkplain Thread#getDefaultUncaughtExceptionHandler() handler} of the program.
 */
final class Mailbox<T> {
  /** A listener that is further behind misses what comes. */
  private static final int LIMIT = 10_000;

  private static final long PATIENCE_SECONDS = 1;

  /** Daemons, and platform threads: a busy listener must not take a carrier from the kernel. */
  static final Executor THREADS =
      new ThreadPoolExecutor(
          0,
          Integer.MAX_VALUE,
          5,
          TimeUnit.SECONDS,
          new SynchronousQueue<>(),
          Thread.ofPlatform().daemon().name("urbi-listener-", 0).factory());

  private final Scheduler scheduler;
  private final Consumer<? super T> listener;
  private final ConcurrentLinkedQueue<Runnable> queue = new ConcurrentLinkedQueue<>();
  private final AtomicInteger behind = new AtomicInteger();
  private final AtomicInteger missed = new AtomicInteger();
  private final AtomicBoolean delivering = new AtomicBoolean();
  private volatile @Nullable Thread deliverer;
  private volatile boolean closed;
  private boolean announced;

  Mailbox(Scheduler scheduler, Consumer<? super T> listener) {
    this.scheduler = scheduler;
    this.listener = listener;
  }

  /** Leaves a message; on the kernel thread. It is on its way when the tick ends. */
  void post(T message) {
    if (closed) {
      return;
    }
    if (behind.incrementAndGet() > LIMIT) {
      behind.decrementAndGet();
      missed.incrementAndGet();
      return;
    }
    queue.add(() -> deliver(message));
    if (!announced) {
      announced = true;
      // Not at once: this may be a job, whose thread must not wait for a lock.
      scheduler.atEndOfTick(() -> {
        announced = false;
        start();
      });
    }
  }

  private void deliver(T message) {
    behind.decrementAndGet();
    if (!closed) {
      listener.accept(message);
    }
  }

  /** Sees to it that somebody delivers what is there; from any thread but that of a job. */
  void start() {
    if (!queue.isEmpty() && delivering.compareAndSet(false, true)) {
      try {
        THREADS.execute(this::run);
      } catch (OutOfMemoryError e) {
        // No more threads: the next message will try again.
        delivering.set(false);
      }
    }
  }

  private void run() {
    do {
      deliverer = Thread.currentThread();
      Runnable next;
      while ((next = queue.poll()) != null) {
        attempt(next);
        int lost = missed.getAndSet(0);
        if (lost > 0) {
          attempt(() -> {
            throw new IllegalStateException(
                "a listener is too slow and has missed " + lost + " messages");
          });
        }
      }
      deliverer = null;
      delivering.set(false);
    } while (!queue.isEmpty() && delivering.compareAndSet(false, true));
  }

  private static void attempt(Runnable call) {
    try {
      call.run();
    } catch (Throwable failure) {
      FailureLog.component("delivering to a listener", failure);
      Thread.UncaughtExceptionHandler handler = Thread.getDefaultUncaughtExceptionHandler();
      if (handler != null) {
        tell(handler, failure);
      }
    }
  }

  private static void tell(Thread.UncaughtExceptionHandler handler, Throwable failure) {
    try {
      handler.uncaughtException(Thread.currentThread(), failure);
    } catch (Throwable ignored) {
      // As the Java virtual machine does with what a handler throws.
    }
  }

  /**
   * Waits until what has been posted so far is delivered, but not for a listener that takes its
   * time, nor for the caller itself.
   */
  void flush() throws InterruptedException {
    if (deliverer == Thread.currentThread() || (queue.isEmpty() && !delivering.get())) {
      return;
    }
    CountDownLatch reached = new CountDownLatch(1);
    queue.add(reached::countDown);
    start();
    reached.await(PATIENCE_SECONDS, TimeUnit.SECONDS);
  }

  void close() {
    closed = true;
  }
}
