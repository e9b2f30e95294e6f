package org.urbi.kernel.observe;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What has changed since somebody looked last. One view is about a limited number of jobs: several
 * make a round over all of them.
 *
 * @param machine the time of the machine, in nanoseconds
 * @param time of the kernel, in nanoseconds since its start
 * @param epochTime the same, in nanoseconds since the Epoch
 * @param total how many jobs there are
 * @param jobs that are new, or have changed
 * @param gone the numbers of the jobs that have ended
 * @param tags that are new, or have changed
 * @param tagsGone the numbers of the tags under which there is nothing any more
 * @param turns of the traced jobs, and which jobs those are
 * @param detail of the selected job, at the end of a round; null if there is none
 * @param reactions and events, at the end of a round; null if they are not wanted
 * @param variables the slots of objects, at the end of a round; null if they are not wanted
 * @param complete whether it is the end of a round
 */
public record View(
    long machine,
    long time,
    long epochTime,
    int total,
    List<JobRow> jobs,
    List<Long> gone,
    List<TagRow> tags,
    List<Long> tagsGone,
    TurnView turns,
    @Nullable JobDetail detail,
    @Nullable ReactionView reactions,
    @Nullable VariableView variables,
    boolean complete) {
  /** Whether it has nothing to tell but the time: in the middle of a round, most have not. */
  public boolean isVoid() {
    return !complete && jobs.isEmpty() && gone.isEmpty() && tags.isEmpty() && turns.isVoid();
  }
}
