package org.urbi.kernel.embed;

import java.time.Duration;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.log.FailureLog;

/**
 * The messages of the kernel to one listener, delivered one by one, in order, on a thread other
 * than the kernel's. A listener that blocks delays nobody but itself; what it throws goes to the
 * log, and to the {@linkplain Thread#getDefaultUncaughtExceptionHandler() handler} of the program.
 */
final class ListenerQueue<T> {
  /** A listener with more messages waiting than this misses the next ones. */
  private static final int LIMIT = 10_000;

  private static final long CLOSE_TIMEOUT_SECONDS = 1;

  /** Daemons, and platform threads: a busy listener must not take a carrier from the kernel. */
  static final Executor THREADS = FailureLog.THREADS.pool("urbi-listener-", Duration.ofSeconds(5));

  private final Scheduler scheduler;
  private final Consumer<? super T> listener;
  private final ConcurrentLinkedQueue<Runnable> queue = new ConcurrentLinkedQueue<>();
  private final AtomicInteger behind = new AtomicInteger();
  private final AtomicInteger missed = new AtomicInteger();
  private final AtomicBoolean delivering = new AtomicBoolean();
  private volatile @Nullable Thread deliverer;
  private volatile boolean closed;
  private boolean announced;

  ListenerQueue(Scheduler scheduler, Consumer<? super T> listener) {
    this.scheduler = scheduler;
    this.listener = listener;
  }

  /** Adds a message; on the kernel thread. Its delivery starts at the end of the tick. */
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
      // Once for all messages of the tick: to start a delivery takes a lock.
      scheduler.atEndOfTick(() -> {
        announced = false;
        start();
      });
      announced = true;
    }
  }

  private void deliver(T message) {
    behind.decrementAndGet();
    if (!closed) {
      listener.accept(message);
    }
  }

  /**
   * Starts a thread that delivers the waiting messages, unless one is running. Not to be called on
   * the thread of a job.
   */
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
      // The Java virtual machine ignores exceptions of these handlers, too.
    }
  }

  /**
   * Waits until the messages posted so far are delivered; but not for a slow listener, nor if the
   * caller is that listener.
   */
  void flush() throws InterruptedException {
    if (deliverer == Thread.currentThread() || (queue.isEmpty() && !delivering.get())) {
      return;
    }
    CountDownLatch reached = new CountDownLatch(1);
    queue.add(reached::countDown);
    start();
    reached.await(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS);
  }

  void close() {
    closed = true;
  }
}
