package urbi.remote;

import java.util.concurrent.TimeUnit;
import urbi.time.Stopwatch;

/**
 * Estimates the time of the kernel from the time stamps of its messages; the messages with the
 * least delay count.
 */
final class KernelTime {
  private volatile long ahead = Long.MIN_VALUE;

  private static long here() {
    return TimeUnit.NANOSECONDS.toMicros(Stopwatch.nanoseconds());
  }

  /** The kernel says that it was that time, in microseconds since its start, a moment ago. */
  void heard(long time) {
    long difference = time - here();
    if (difference > ahead) {
      ahead = difference;
    }
  }

  /** Microseconds since the kernel was started; 0 if it has not said yet. */
  long now() {
    long difference = ahead;
    return difference == Long.MIN_VALUE ? 0 : difference + here();
  }
}
