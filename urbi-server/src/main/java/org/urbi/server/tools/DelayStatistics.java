package org.urbi.server.tools;

import java.util.Locale;

/** The delays that {@code urbi-ping} has measured, for its last line. */
final class DelayStatistics {
  private int sent;
  private int received;
  private long least = Long.MAX_VALUE;
  private long most;
  private double sum;

  synchronized void sent() {
    ++sent;
  }

  synchronized void add(long nanoseconds) {
    ++received;
    least = Math.min(least, nanoseconds);
    most = Math.max(most, nanoseconds);
    sum += nanoseconds;
  }

  synchronized int received() {
    return received;
  }

  static String milliseconds(double nanoseconds) {
    return String.format(Locale.ROOT, "%.3f ms", nanoseconds / 1e6);
  }

  @Override
  public synchronized String toString() {
    String counts = sent + " sent, " + received + " received";
    return received == 0
        ? counts
        : counts
            + ", min "
            + milliseconds(least)
            + ", mean "
            + milliseconds(sum / received)
            + ", max "
            + milliseconds(most);
  }
}
