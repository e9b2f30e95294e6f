package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

/** The end of all the jobs of a group. */
final class StopOfGroup extends Stop {
  private final JobGroup group;
  private final Iterator<Job> left;

  StopOfGroup(JobGroup group, JobList live) {
    this.group = group;
    List<Job> all = new ArrayList<>(live.size());
    live.addTo(all);
    this.left = all.iterator();
  }

  @Override
  boolean step() {
    boolean more = left.hasNext();
    if (more) {
      end(left.next());
    }
    return more;
  }

  @Override
  void reach(Job job) {
    if (job.isOf(group)) {
      job.terminate();
    }
  }
}
