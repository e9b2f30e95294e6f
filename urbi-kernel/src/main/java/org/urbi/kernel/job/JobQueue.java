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
    for (Job job = first; job != null; job = job.queueLink.after) {
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
    Link link = job.queueLink;
    if (link.queue != null) {
      return false;
    }
    link.queue = this;
    link.before = last;
    if (last == null) {
      first = job;
    } else {
      last.queueLink.after = job;
    }
    last = job;
    size++;
    return true;
  }

  /** Adds a job before the others; one that is in a queue already stays there: then false. */
  boolean addFirst(Job job) {
    Link link = job.queueLink;
    if (link.queue != null) {
      return false;
    }
    link.queue = this;
    link.after = first;
    if (first == null) {
      last = job;
    } else {
      first.queueLink.before = job;
    }
    first = job;
    size++;
    return true;
  }

  /** Takes the first job out; null if there is none. */
  @Nullable Job poll() {
    Job job = first;
    if (job != null) {
      remove(job.queueLink);
    }
    return job;
  }

  /** Takes the last job out; null if there is none. */
  @Nullable Job pollLast() {
    Job job = last;
    if (job != null) {
      remove(job.queueLink);
    }
    return job;
  }

  private void remove(Link link) {
    if (link.before == null) {
      first = link.after;
    } else {
      link.before.queueLink.after = link.after;
    }
    if (link.after == null) {
      last = link.before;
    } else {
      link.after.queueLink.before = link.before;
    }
    link.before = null;
    link.after = null;
    link.queue = null;
    size--;
  }

  /** Where a job is in a queue. */
  static final class Link {
    private @Nullable JobQueue queue;
    private @Nullable Job before;
    private @Nullable Job after;

    /** Takes the job out of the queue that it is in, and returns that queue; null if in none. */
    @Nullable JobQueue leave() {
      JobQueue left = queue;
      if (left != null) {
        left.remove(this);
      }
      return left;
    }
  }
}
