package org.urbi.kernel.budget;

import java.util.Locale;
import org.urbi.kernel.error.Problem;

/** A limited resource, of which a lobby could take too much. */
public enum Resource {
  /** Jobs that have not ended. */
  JOBS(Problem.OF_JOBS),
  /** Timers other than those of sleeping jobs: timeouts, conditions that must hold for a while. */
  TIMERS(Problem.OF_TIMERS),
  /** Programs that run. */
  PROCESSES(Problem.OF_PROCESSES),
  /** Bytes of output that the client has not read yet. */
  OUTPUT(Problem.OF_OUTPUT),
  /** Bytes of input that cannot be executed, since the end of its statement is missing. */
  INPUT(Problem.OF_INPUT),
  /** The percentage of the kernel's time. */
  TIME(Problem.OF_TIME),
  /** Milliseconds for which a job may hold the kernel without letting others run. */
  HOLD(Problem.OF_HOLD),
  /** Bytes of memory that a job may allocate without letting others run. */
  MEMORY(Problem.OF_MEMORY),
  /** Nested calls of functions. */
  DEPTH(Problem.OF_DEPTH);

  private final Problem unit;

  Resource(Problem unit) {
    this.unit = unit;
  }

  /** The word for it in options and programs. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The unit as error messages show it. */
  public String unit() {
    return unit.text();
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
