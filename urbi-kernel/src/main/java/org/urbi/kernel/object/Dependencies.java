package org.urbi.kernel.object;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The watchers of one thing that can change (a slot, the set of slots of an object, the content of
 * a container, a local variable): the conditions which read it when they were last evaluated.
 */
public final class Dependencies {
  /** A condition that must be evaluated again after a change. */
  public interface Watcher {
    /** Something that the condition read has changed. */
    void invalidated();

    /**
     * Something that the condition read has changed, and the job that has changed it must end: it
     * may spend no more time on this, except on the conditions of others.
     */
    default void invalidatedLater() {
      invalidated();
    }

    /** What watches, for people; empty if they need not know. */
    default String description() {
      return "";
    }
  }

  /** Collects what the evaluation of a condition reads. */
  public interface Tracker {
    /** The condition has read this. */
    void read(Dependencies source);
  }

  /** That a watcher is called at each change of one thing, until it {@linkplain #end ends}. */
  public static final class Watch {
    private final Dependencies source;
    private final Watcher watcher;
    private @Nullable Watch before;
    private @Nullable Watch after;
    private boolean over;

    /** The number that its owner has given to the last evaluation that read the source. */
    private long evaluation;

    private Watch(Dependencies source, Watcher watcher) {
      this.source = source;
      this.watcher = watcher;
    }

    /** What is watched. */
    public Dependencies source() {
      return source;
    }

    /**
     * The evaluation of that number has read the source.
     *
     * @param number not 0
     * @return false if it had read it before
     */
    public boolean readBy(long number) {
      boolean first = evaluation != number;
      evaluation = number;
      return first;
    }

    /** Whether the evaluation of that number has read the source. */
    public boolean wasReadBy(long number) {
      return evaluation == number;
    }

    /** Ends it; the watcher is not called any more. */
    public void end() {
      if (!over) {
        over = true;
        source.remove(this);
      }
    }
  }

  private final String name;
  private @Nullable Watch first;
  private @Nullable Watch last;
  private int size;

  /**
   * @param name of what can change, for people; empty for the set of slots of an object, which
   *     every look for a name reads
   */
  public Dependencies(String name) {
    this.name = name;
  }

  /** The name of what can change, for people; may be empty. */
  public String name() {
    return name;
  }

  /** Adds a watcher, which is called at each change until its watch ends. */
  public Watch add(Watcher watcher) {
    Watch added = new Watch(this, watcher);
    added.before = last;
    if (last == null) {
      first = added;
    } else {
      last.after = added;
    }
    last = added;
    size++;
    return added;
  }

  private void remove(Watch ended) {
    Watch before = ended.before;
    Watch after = ended.after;
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
    ended.before = null;
    ended.after = null;
    size--;
  }

  /**
   * What watches, for people.
   *
   * @param most so many at most
   */
  public List<String> watchers(int most) {
    List<String> all = new ArrayList<>();
    for (Watch watch = first; watch != null && all.size() < most; watch = watch.after) {
      all.add(watch.watcher.description());
    }
    return all;
  }

  /** How many watch. */
  public int size() {
    return size;
  }

  public boolean isEmpty() {
    return first == null;
  }

  /**
   * Calls every watcher, in the order in which they were added. What one of them throws goes on to
   * the caller; the change must not be lost to the others.
   */
  public void changed() {
    if (first == null) {
      return;
    }
    // Watchers are added and removed while they are called.
    Watch[] told = new Watch[size];
    int known = 0;
    for (Watch watch = first; watch != null; watch = watch.after) {
      told[known++] = watch;
    }
    int next = 0;
    try {
      for (; next < told.length; next++) {
        if (!told[next].over) {
          told[next].watcher.invalidated();
        }
      }
    } finally {
      for (; next < told.length; next++) {
        if (!told[next].over) {
          told[next].watcher.invalidatedLater();
        }
      }
    }
  }
}
