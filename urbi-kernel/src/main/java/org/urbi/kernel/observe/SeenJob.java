package org.urbi.kernel.observe;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Located;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.lobby.UrbiLobby;

/** What somebody has been told of a job. On the kernel thread. */
final class SeenJob {
  private static final int THOUSAND = 1000;

  private final long number;
  private @Nullable Wait wait;
  private boolean frozen;
  private @Nullable Located where;
  private @Nullable TagScope scope;
  private List<Long> tags = List.of();
  private long time;
  private long ran;
  private int share;

  SeenJob(Job job, long now, long ran) {
    number = job.number();
    time = now;
    this.ran = ran;
  }

  long number() {
    return number;
  }

  /**
   * Looks at the job again.
   *
   * @param now the time of the machine, in nanoseconds
   * @param runs how long its turns have lasted, in nanoseconds
   * @return whether something has changed, or this is the first look
   */
  boolean update(Job job, SeenTags known, long now, long runs) {
    int took = now > time ? (int) ((runs - ran) * THOUSAND / (now - time)) : share;
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

  JobRow row(Job job) {
    return new JobRow(
        number,
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
