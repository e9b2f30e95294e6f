package org.urbi.ros.uobject;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.LongFunction;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.time.SteadyClock;

/**
 * Tells when nothing has come for too long, counted from the first message on, and again whenever
 * that time has passed once more.
 */
final class Deadline {
  /** The shortest time between two looks: whoever asks for less must not fill the kernel. */
  static final long SHORTEST = TimeUnit.MILLISECONDS.toNanos(1);

  private final long period;
  private final Runnable missed;
  private final LongSupplier clock;
  private final LongFunction<CompletableFuture<Void>> timers;
  private @Nullable CompletableFuture<Void> timer;
  private long last;
  private boolean ended;

  /**
   * @param period zero for none: then nothing is told
   * @param missed does not wait, and throws nothing
   */
  Deadline(Duration period, Runnable missed) {
    this(
        period,
        missed,
        SteadyClock::nanoseconds,
        wait -> new CompletableFuture<Void>().completeOnTimeout(null, wait, TimeUnit.NANOSECONDS));
  }

  /**
   * With a time of its own.
   *
   * @param timers makes what is done after so many nanoseconds, unless it is cancelled
   */
  Deadline(
      Duration period,
      Runnable missed,
      LongSupplier clock,
      LongFunction<CompletableFuture<Void>> timers) {
    this.period = period.isZero() ? 0 : Math.max(period.toNanos(), SHORTEST);
    this.missed = missed;
    this.clock = clock;
    this.timers = timers;
  }

  /** A message has come. */
  void heard() {
    if (period == 0) {
      return;
    }
    synchronized (this) {
      last = clock.getAsLong();
      if (timer == null && !ended) {
        waitFor(period);
      }
    }
  }

  private void waitFor(long nanoseconds) {
    CompletableFuture<Void> next = timers.apply(nanoseconds);
    timer = next;
    next.thenRunAsync(this::due);
  }

  private void due() {
    synchronized (this) {
      if (ended) {
        return;
      }
      long now = clock.getAsLong();
      long left = last + period - now;
      if (left > 0) {
        waitFor(left);
        return;
      }
      last = now;
      waitFor(period);
    }
    missed.run();
  }

  /** Nothing is told any more, and nothing waits. */
  synchronized void end() {
    ended = true;
    if (timer != null) {
      timer.cancel(false);
    }
  }
}
