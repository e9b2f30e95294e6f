package org.urbi.kernel.budget;

import java.util.Locale;
import org.urbi.kernel.error.Problem;

/** A limited resource, of which a lobby could take too much. */
public enum Resource {
  /** Jobs that have not ended. */
  JOBS("jobs"),
  /** Timers other than those of sleeping jobs: timeouts, conditions that must hold for a while. */
  TIMERS("timers"),
  /** Programs that run. */
  PROCESSES("processes"),
  /** Bytes of output that the client has not read yet. */
  OUTPUT("bytes of unread output"),
  /** Bytes of input that cannot be executed, since the end of its statement is missing. */
  INPUT("bytes of unfinished input"),
  /** The percentage of the kernel's time. */
  TIME("% of the kernel's time"),
  /** Milliseconds for which a job may hold the kernel without letting others run. */
  HOLD("ms without letting others run"),
  /** Bytes of memory that a job may allocate without letting others run. */
  MEMORY("bytes allocated without letting others run"),
  /** Nested calls of functions. */
  DEPTH("nested calls");

  private final String unit;

  Resource(String unit) {
    this.unit = unit;
  }

  /** The word for it in options and programs. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The unit as error messages show it. */
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
