package org.urbi.kernel.node;

import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobLocal;

/** Where a job may define slots that exist already (manual, "System", {@code redefinitionMode}). */
public final class RedefinitionMode {
  /** The number of surrounding scopes in which a job may redefine slots. */
  private static final JobLocal<Integer> ALLOWED = new JobLocal<>();

  private RedefinitionMode() {}

  /** The number of surrounding scopes in which that job may redefine slots. */
  public static int allowed(Job job) {
    Integer allowed = ALLOWED.get(job);
    return allowed == null ? 0 : allowed;
  }

  /** Allows slots to be redefined from now on. */
  public static void allow(Job job) {
    ALLOWED.set(job, allowed(job) + 1);
  }

  /** Leaves scopes in which slots may be redefined, until only that many remain. */
  public static void end(Job job, int before) {
    if (allowed(job) > before) {
      ALLOWED.set(job, before);
    }
  }
}
