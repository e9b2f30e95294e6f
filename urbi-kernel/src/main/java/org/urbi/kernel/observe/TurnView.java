package org.urbi.kernel.observe;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Turn;

/**
 * The turns of the traced jobs since somebody looked last, and of which jobs and times he is told
 * them: that no turn is told does not mean that a job had none. Times are of the machine, in
 * nanoseconds.
 *
 * @param turns of the jobs that were traced, and the first ones of new jobs
 * @param lostUntil turns before that were not kept, because there were too many; 0 if none is
 *     missing
 * @param traced the numbers of the jobs that are traced from now on, and since when all turns of
 *     each have been told; null if that has not changed
 */
public record TurnView(List<Turn> turns, long lostUntil, @Nullable Map<Long, Long> traced) {
  /** Whether it has nothing to tell. */
  boolean isVoid() {
    return turns.isEmpty() && lostUntil == 0 && traced == null;
  }
}
