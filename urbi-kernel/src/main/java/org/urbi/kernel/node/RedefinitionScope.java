package org.urbi.kernel.node;

import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobLocal;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * A scope whose code may ask for {@code redefinitionMode} or {@code nonInterruptible}, which end
 * with the scope (manual, "System").
 */
public final class RedefinitionScope extends Node {
  /** The number of surrounding scopes in which a job may redefine slots. */
  private static final JobLocal<Integer> ALLOWED = new JobLocal<>();

  private final Node body;

  public RedefinitionScope(Span span, Node body) {
    super(span);
    this.body = body;
  }

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

  @Override
  public UrbiObject execute(Frame frame) {
    int before = allowed(frame.job);
    int held = frame.job.nonInterruptible();
    try {
      return body.execute(frame);
    } finally {
      end(frame.job, before);
      frame.job.endNonInterruptible(held);
    }
  }
}
