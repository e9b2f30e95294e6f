package urbi.time;

import java.util.concurrent.TimeUnit;

/** How long ago something was. May be read and started again by any thread. */
public final class Stopwatch {
  private volatile long start = nanoseconds();

  /** The machine's time in nanoseconds, from some beginning that does not change. */
  public static long nanoseconds() {
    return System.nanoTime();
  }

  /** Begins again from zero. */
  public void restart() {
    start = nanoseconds();
  }

  /** Time that has passed since the start, in whole units. */
  public long elapsed(TimeUnit unit) {
    return unit.convert(nanoseconds() - start, TimeUnit.NANOSECONDS);
  }
}
