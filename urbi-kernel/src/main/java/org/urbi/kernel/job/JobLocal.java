package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;

/**
 * A variable with a separate value for each job, as {@link ThreadLocal} is for threads. A package
 * of the kernel uses it to keep data for a job, without the job knowing that package.
 */
public final class JobLocal<T> {
  /** A value in one job; the others follow. */
  static final class Entry {
    final JobLocal<?> variable;
    final @Nullable Entry next;
    Object value;

    Entry(JobLocal<?> variable, Object value, @Nullable Entry next) {
      this.variable = variable;
      this.value = value;
      this.next = next;
    }
  }

  /** The value in a job; null when none was set. */
  // Only set puts values of this key in, and they are of type T.
  @SuppressWarnings("unchecked")
  public @Nullable T get(Job job) {
    Entry entry = find(job);
    return entry == null ? null : (T) entry.value;
  }

  /** Sets the value in a job. */
  public void set(Job job, T value) {
    Entry entry = find(job);
    if (entry == null) {
      job.locals = new Entry(this, value, job.locals);
    } else {
      entry.value = value;
    }
  }

  private @Nullable Entry find(Job job) {
    Entry entry = job.locals;
    while (entry != null && entry.variable != this) {
      entry = entry.next;
    }
    return entry;
  }
}
