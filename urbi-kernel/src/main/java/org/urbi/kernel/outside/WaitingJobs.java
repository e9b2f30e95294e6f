package org.urbi.kernel.outside;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Wait;

/** Jobs that wait for something to become true; on the kernel thread. */
final class WaitingJobs {
  private final Set<Job> jobs = new LinkedHashSet<>();

  /** Makes the job wait until the condition holds. */
  void await(Job job, BooleanSupplier condition) {
    while (!condition.getAsBoolean()) {
      jobs.add(job);
      try {
        job.waitForWake(Wait.FILE);
      } finally {
        jobs.remove(job);
      }
    }
  }

  /** Something has changed: wakes the jobs, which check their conditions again. */
  void wake() {
    List.copyOf(jobs).forEach(Job::wake);
  }
}
