package org.urbi.kernel.budget;

import java.util.Locale;
import org.urbi.kernel.error.Problem;

/** What there is only so much of, and a lobby can take too much of. */
public enum Resource {
  /** Jobs that have not ended. */
  JOBS("jobs"),
  /** What is to happen later besides the jobs that sleep: timeouts, conditions that must hold. */
  TIMERS("timers"),
  /** Programs that run. */
  PROCESSES("processes"),
  /** Bytes that the client has been sent and has not taken. */
  OUTPUT("bytes of unread output"),
  /** Bytes of input that cannot be executed, since the end of its statement is missing. */
  INPUT("bytes of unfinished input"),
  /** Of each second of the kernel's time. */
  TIME("% of the kernel's time");

  private final String unit;

  Resource(String unit) {
    this.unit = unit;
  }

  /** The word for it in options and programs. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What is counted, for people. */
  public String unit() {
    return unit;
  }

  /**
   * The one with that word.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static Resource of(String word) {
    for (Resource each : values()) {
      if (each.word().equals(word)) {
        return each;
      }
    }
    throw new IllegalArgumentException(Problem.NO_SUCH_BUDGET.text(word));
  }
}
