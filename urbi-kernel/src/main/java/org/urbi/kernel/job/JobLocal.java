package org.urbi.kernel.job;

/**
 * A variable of which every job has a value of its own, as a {@link ThreadLocal} is one of threads:
 * what a room of the kernel keeps for a job that need not know of it.
 */
public final class JobLocal<T> {
  /** A value in one job; the others follow. */
  static final class Entry {
    final JobLocal<?> variable;
    final Entry next;
    Object value;

    Entry(JobLocal<?> variable, Entry next) {
      this.variable = variable;
      this.next = next;
    }
  }

  /** The value in a job; null when none was set. */
  @SuppressWarnings("unchecked")
  public T get(Job job) {
    Entry entry = find(job);
    return entry == null ? null : (T) entry.value;
  }

  /** Sets the value in a job. */
  public void set(Job job, T value) {
    Entry entry = find(job);
    if (entry == null) {
      entry = new Entry(this, job.locals);
      job.locals = entry;
    }
    entry.value = value;
  }

  private Entry find(Job job) {
    Entry entry = job.locals;
    while (entry != null && entry.variable != this) {
      entry = entry.next;
    }
    return entry;
  }
}
