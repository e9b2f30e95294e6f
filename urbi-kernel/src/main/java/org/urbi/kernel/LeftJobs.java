package org.urbi.kernel;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.lobby.Shell;

/**
 * The jobs that clients leave behind when they go, because the jobs are under no tag ({@code
 * spawn(function, true)}; manual, "Job"). All of them together may be as many as one client may
 * have; when there are more, they are ended. On the kernel thread.
 */
final class LeftJobs {
  private final Scheduler scheduler;
  private final Set<Budget> gone = Collections.newSetFromMap(new IdentityHashMap<>());

  LeftJobs(Scheduler scheduler) {
    this.scheduler = scheduler;
  }

  /** The client with that budget has gone. */
  void add(Budget budget) {
    gone.removeIf(each -> each.used(Resource.JOBS) == 0);
    long most = budget.limit(Resource.JOBS);
    if (gone.stream().mapToLong(each -> each.used(Resource.JOBS)).sum() > most) {
      List<Job> left =
          scheduler.jobs().stream()
              .filter(job -> gone.contains(job.budget()) && !job.isEnding())
              .toList();
      // What is ending already is not counted again.
      gone.clear();
      if (left.size() > most) {
        left.forEach(Job::terminate);
      } else {
        left.forEach(job -> gone.add(job.budget()));
      }
    }
    gone.add(budget);
  }

  /** Ends the jobs of a client that is still there, even those under no tag; not its shell. */
  void end(Budget budget, Shell shell) {
    for (Job job : scheduler.jobs()) {
      if (job.budget() == budget && !shell.isExecutedBy(job)) {
        job.terminate();
      }
    }
  }
}
