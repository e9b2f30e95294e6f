package org.urbi.kernel.job;

import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/**
 * Jobs in the order in which they will run. The jobs themselves are linked, so a job is in one
 * queue at most, and to add or move one takes no memory: when there is none left, no job may be
 * lost on its way from one queue to another.
 */
final class JobQueue {
  private @Nullable Job first;
  private @Nullable Job last;
  private int size;

  boolean isEmpty() {
    return first == null;
  }

  int size() {
    return size;
  }

  boolean hasAny(Predicate<Job> condition) {
    for (Job job = first; job != null; job = job.queueAfter) {
      if (condition.test(job)) {
        return true;
      }
    }
    return false;
  }

  /** The first job; null if there is none. */
  @Nullable Job first() {
    return first;
  }

  /** Adds a job behind the others; one that is in a queue already stays there: then false. */
  boolean add(Job job) {
    if (job.queue != null) {
      return false;
    }
    job.queue = this;
    job.queueBefore = last;
    if (last == null) {
      first = job;
    } else {
      last.queueAfter = job;
    }
    last = job;
    size++;
    return true;
  }

  /** Adds a job before the others; one that is in a queue already stays there: then false. */
  boolean addFirst(Job job) {
    if (job.queue != null) {
      return false;
    }
    job.queue = this;
    job.queueAfter = first;
    if (first == null) {
      last = job;
    } else {
      first.queueBefore = job;
    }
    first = job;
    size++;
    return true;
  }

  /** Takes the first job out; null if there is none. */
  @Nullable Job poll() {
    Job job = first;
    if (job != null) {
      remove(job);
    }
    return job;
  }

  /** Takes the last job out; null if there is none. */
  @Nullable Job pollLast() {
    Job job = last;
    if (job != null) {
      remove(job);
    }
    return job;
  }

  /** Takes a job out of the queue that it is in, and returns that queue; null if in none. */
  static @Nullable JobQueue leave(Job job) {
    JobQueue left = job.queue;
    if (left != null) {
      left.remove(job);
    }
    return left;
  }

  private void remove(Job job) {
    Job before = job.queueBefore;
    Job after = job.queueAfter;
    if (before == null) {
      first = after;
    } else {
      before.queueAfter = after;
    }
    if (after == null) {
      last = before;
    } else {
      after.queueBefore = before;
    }
    job.queueBefore = null;
    job.queueAfter = null;
    job.queue = null;
    size--;
  }
}
