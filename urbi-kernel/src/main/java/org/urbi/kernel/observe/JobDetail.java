package org.urbi.kernel.observe;

import java.util.List;

/**
 * More of one job.
 *
 * @param number of the job
 * @param left for how many more seconds it waits; negative unless it waits for a time
 * @param calls that go on, innermost first
 */
public record JobDetail(long number, double left, List<Call> calls) {
  /**
   * A call that goes on.
   *
   * @param name of what was called; empty for the code itself
   * @param place where in the source; empty when nobody knows
   * @param line that line of the source
   */
  public record Call(String name, String place, String line) {}
}
