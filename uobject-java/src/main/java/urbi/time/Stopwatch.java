package urbi.time;

import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/** Measures how long ago something happened. Any thread may read and restart it. */
public final class Stopwatch {
  private final LongSupplier clock;
  private volatile long start;

  /** Goes by the machine's time. */
  public Stopwatch() {
    this(Stopwatch::nanoseconds);
  }

  /** Goes by another clock, in nanoseconds from some beginning. */
  public Stopwatch(LongSupplier clock) {
    this.clock = clock;
    restart();
  }

  /** The machine's time in nanoseconds, from some beginning that does not change. */
  public static long nanoseconds() {
    return System.nanoTime();
  }

  /** Begins again from zero. */
  public void restart() {
    start = clock.getAsLong();
  }

  /** Time that has passed since the start, in whole units. */
  public long elapsed(TimeUnit unit) {
    return unit.convert(clock.getAsLong() - start, TimeUnit.NANOSECONDS);
  }
}
