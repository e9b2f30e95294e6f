package org.urbi.kernel.observe;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobState;
import org.urbi.kernel.job.Located;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.lobby.UrbiLobby;

/** What somebody has been told of a job. On the kernel thread. */
final class SeenJob {
  private static final int THOUSAND = 1000;

  private final Job job;
  private @Nullable Wait wait;
  private boolean frozen;
  private @Nullable Located where;
  private @Nullable TagScope scope;
  private List<Long> tags = List.of();
  private long time;
  private long ran;
  private int share;

  /**
   * @param now the time of the machine, in nanoseconds
   * @param ran how long its turns have lasted, in nanoseconds
   */
  SeenJob(Job job, long now, long ran) {
    this.job = job;
    time = now;
    this.ran = ran;
  }

  Job job() {
    return job;
  }

  boolean isOver() {
    return job.state() == JobState.ENDED;
  }

  /** Whether it had a share of the kernel's time when it was last looked at. */
  boolean isActive() {
    return share > 0;
  }

  /**
   * Looks at the job again.
   *
   * @param since the time of the machine when all jobs were looked at last: it may have been left
   *     out then, because it had not changed
   * @param now that time at present, in nanoseconds
   * @param runs how long its turns have lasted, in nanoseconds
   * @return whether something has changed, or this is the first look
   */
  boolean update(SeenTags known, long since, long now, long runs) {
    long before = Math.max(time, since);
    int took = now > before ? (int) ((runs - ran) * THOUSAND / (now - before)) : share;
    boolean same =
        wait == job.waitsFor()
            && frozen == job.isFrozen()
            && where == job.where()
            && scope == job.scope()
            && share == took;
    time = now;
    ran = runs;
    if (same) {
      return false;
    }
    share = took;
    wait = job.waitsFor();
    frozen = job.isFrozen();
    where = job.where();
    if (scope != job.scope()) {
      scope = job.scope();
      tags = known.of(scope);
    }
    return true;
  }

  JobRow row() {
    return new JobRow(
        job.number(),
        job.name(),
        job.starter(),
        job.lobby() instanceof UrbiLobby lobby ? lobby.name() : "",
        job.waitsFor().text(),
        frozen,
        Written.place(job.where() == null ? null : job.where().span()),
        Written.beginning(job.where() == null ? null : job.where().span()),
        tags,
        share);
  }
}
