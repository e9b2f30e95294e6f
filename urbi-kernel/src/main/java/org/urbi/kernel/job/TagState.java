package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/**
 * What a tag does to the code it labels (manual, "Tag"): stop, block, freeze. The urbiscript object
 * Tag is based on it.
 */
public final class TagState {
  final Set<TagScope> scopes = new LinkedHashSet<>();
  private final @Nullable UrbiObject owner;
  private boolean frozen;
  private @Nullable UrbiObject blockedValue;

  private final boolean detached;
  private long number;

  /** A tag that no code can name. */
  public TagState() {
    this(null, false);
  }

  private TagState(@Nullable UrbiObject owner, boolean detached) {
    this.owner = owner;
    this.detached = detached;
  }

  /** A tag that no code can name, for what is to outlive the connection that started it. */
  public static TagState ofDetached() {
    return new TagState(null, true);
  }

  /** Whether it is for what is to outlive its connection. */
  boolean isDetached() {
    return detached;
  }

  /**
   * @param owner the urbiscript object of this tag
   */
  public TagState(UrbiObject owner) {
    this(owner, false);
  }

  /** The urbiscript object of this tag, or null. */
  public @Nullable UrbiObject owner() {
    return owner;
  }

  /** A number that no other tag of the kernel has; 0 until code enters it. */
  public long number() {
    return number;
  }

  void setNumber(long given) {
    number = given;
  }

  /** Whether code is under this tag that has not been left, or anything that it has left there. */
  public boolean isUsed() {
    return !scopes.isEmpty();
  }

  /** Whether nothing is running under this tag, not even what has been frozen. */
  public boolean isIdle() {
    for (TagScope scope : scopes) {
      if (scope.hasJobs()) {
        return false;
      }
    }
    return true;
  }

  /** Whether there is code under this tag that does not wait for anything. */
  public boolean canRun() {
    return jobs().stream().anyMatch(Job::canRun);
  }

  /**
   * Whether all jobs under this tag have been started for that lobby, or for one that shares its
   * budget.
   */
  public boolean isOnlyOf(UrbiObject lobby) {
    return jobs().stream().allMatch(job -> job.budget() == job.scheduler().budgetOf(lobby));
  }

  /** Sets an action that runs once, when the last job under this tag ends. */
  public void onIdle(Runnable action) {
    List<Job> jobs = jobs();
    int[] left = {jobs.size()};
    for (Job job : jobs) {
      job.onEnd(() -> {
        if (--left[0] == 0) {
          action.run();
        }
      });
    }
  }

  public boolean isFrozen() {
    return frozen;
  }

  public boolean isBlocked() {
    return blockedValue != null;
  }

  /** The value that blocked code returns; null if the tag is not blocked. */
  public @Nullable UrbiObject blockedValue() {
    return blockedValue;
  }

  /** Ends all the code that is running under this tag, which returns the value. */
  public void stop(Scheduler scheduler, UrbiObject value) {
    stop(scheduler, value, Long.MAX_VALUE);
  }

  /**
   * Ends the code that is running under this tag, but not what jobs with greater numbers than that
   * have begun, unless it is within what is ended.
   */
  public void stop(Scheduler scheduler, UrbiObject value, long last) {
    scheduler.stops().begin(new StopOfTag(this, value, false, scope -> scope.isOf(last)));
  }

  /** Ends it, but not what statements of a console with greater numbers have begun. */
  public void stopStatements(Scheduler scheduler, UrbiObject value, long last) {
    scheduler.stops().begin(new StopOfTag(this, value, false, scope -> !scope.isAfter(last)));
  }

  /**
   * Ends it without the {@code onleave} clauses of handlers, which wait without a job, and for
   * good: its jobs still clean up, but what they begin then ends with that.
   *
   * @param value what the code returns; null if nobody goes on behind it
   */
  public void abandon(Scheduler scheduler, @Nullable UrbiObject value) {
    scheduler.stops().begin(new StopOfTag(this, value, true, scope -> true));
  }

  /** Whether {@link #stop(Scheduler, UrbiObject, long)} ends that job. */
  public boolean isStopped(Job job, long last) {
    return job.scope().isWithin(this, last);
  }

  /** Ends what waits under this tag without a job (handlers); running code continues. */
  public void dismiss() {
    for (TagScope scope : new ArrayList<>(scopes)) {
      for (TagScope.Attachment attachment : scope.allAttachments()) {
        attachment.stopped(null);
      }
    }
  }

  /** Stops the code under this tag, and lets no more code begin. */
  public void block(Scheduler scheduler, UrbiObject value) {
    blockedValue = value;
    stop(scheduler, value);
  }

  public void unblock() {
    blockedValue = null;
  }

  /**
   * Suspends the code under this tag, and code that enters it later; its time stands still
   * meanwhile. What cleans up for a client that has left goes on (see {@link TagScope#isFrozen}).
   */
  public void freeze() {
    setFrozen(true);
  }

  public void unfreeze() {
    setFrozen(false);
  }

  private void setFrozen(boolean is) {
    if (frozen != is) {
      List<Job> jobs = jobs();
      frozen = is;
      jobs.forEach(Job::followTags);
    }
  }

  private List<Job> jobs() {
    List<Job> jobs = new ArrayList<>();
    for (TagScope scope : scopes) {
      scope.collect(jobs);
    }
    return jobs;
  }
}
