package org.urbi.kernel.job;

import java.util.Collection;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/**
 * Jobs in an order, such as that in which they will run. The links are made with the jobs, so to
 * add, move or remove one takes no memory: when there is none left, no job may be lost on its way
 * from one list to another.
 */
final class JobList {
  private @Nullable Link first;
  private @Nullable Link last;
  private int size;

  /** The place of a job in a list; it is in one at most. */
  static final class Link {
    private final Job job;
    private @Nullable JobList list;
    private @Nullable Link before;
    private @Nullable Link after;

    Link(Job job) {
      this.job = job;
    }

    /** Leaves the list that it is in, and returns that list; null if in none. */
    @Nullable JobList leave() {
      JobList left = list;
      if (left != null) {
        left.take(this);
      }
      return left;
    }
  }

  boolean isEmpty() {
    return first == null;
  }

  int size() {
    return size;
  }

  boolean hasAny(Predicate<Job> condition) {
    for (Link link = first; link != null; link = link.after) {
      if (condition.test(link.job)) {
        return true;
      }
    }
    return false;
  }

  /** Adds all the jobs to a collection. */
  void addTo(Collection<Job> all) {
    for (Link link = first; link != null; link = link.after) {
      all.add(link.job);
    }
  }

  /** The first job; null if there is none. */
  @Nullable Job first() {
    return first == null ? null : first.job;
  }

  /** Adds a job behind the others; one that is in a list already stays there: then false. */
  boolean add(Link link) {
    if (link.list != null) {
      return false;
    }
    link.list = this;
    link.before = last;
    if (last == null) {
      first = link;
    } else {
      last.after = link;
    }
    last = link;
    size++;
    return true;
  }

  /** Adds a job before the others; one that is in a list already stays there: then false. */
  boolean addFirst(Link link) {
    if (link.list != null) {
      return false;
    }
    link.list = this;
    link.after = first;
    if (first == null) {
      last = link;
    } else {
      first.before = link;
    }
    first = link;
    size++;
    return true;
  }

  /** Takes the first job out; null if there is none. */
  @Nullable Job poll() {
    return first == null ? null : take(first);
  }

  /** Takes the last job out; null if there is none. */
  @Nullable Job pollLast() {
    return last == null ? null : take(last);
  }

  private Job take(Link link) {
    Link before = link.before;
    Link after = link.after;
    if (before == null) {
      first = after;
    } else {
      before.after = after;
    }
    if (after == null) {
      last = before;
    } else {
      after.before = before;
    }
    link.before = null;
    link.after = null;
    link.list = null;
    size--;
    return link.job;
  }
}
