package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/**
 * The stop of a tag, on its way to all that is under it: first what waits there without a job, then
 * the jobs, in the order in which they came.
 */
final class StopOfTag extends Stop {
  private final TagState tag;
  private final @Nullable UrbiObject value;
  private final boolean dismissing;
  private final Predicate<TagScope> concerned;
  private final List<TagScope> scopes;
  private final Iterator<TagScope> left;
  private @Nullable ScopeWalk<TagScope.Attachment> handlers;
  private @Nullable ScopeWalk<Job> jobs;

  /** The outermost execution of tagged code whose turn it is. */
  private @Nullable TagScope scope;

  private @Nullable TagStop unwinding;

  /**
   * @param value what the code returns that is stopped; null if all of it ends with its job
   * @param dismissing whether handlers end without their {@code onleave} clauses
   * @param concerned what is stopped of the code under the tag: the rest goes on
   */
  StopOfTag(
      TagState tag, @Nullable UrbiObject value, boolean dismissing, Predicate<TagScope> concerned) {
    this.tag = tag;
    this.value = value;
    this.dismissing = dismissing;
    this.concerned = concerned;
    this.scopes = new ArrayList<>(tag.scopes);
    scopes.removeIf(scope -> !concerned.test(scope));
    if (dismissing) {
      scopes.forEach(TagScope::abandon);
    }
    this.left = scopes.iterator();
  }

  /** Until the end of the pieces handlers under the tag as it is now do not react. */
  @Override
  void beginPieces(int given) {
    super.beginPieces(given);
    scopes.forEach(TagScope::beginStop);
  }

  @Override
  void endPieces() {
    scopes.forEach(TagScope::endStop);
  }

  @Override
  boolean step() {
    if (handlers != null) {
      if (!handlers.step(this::end)) {
        handlers = null;
      }
    } else if (jobs != null) {
      if (!jobs.step(this::end)) {
        jobs = null;
      }
    } else if (left.hasNext()) {
      enter(left.next());
    } else {
      return false;
    }
    return true;
  }

  /** What is under the same tag twice belongs to the outer one. */
  private void enter(TagScope next) {
    if (outermost(next) == next) {
      scope = next;
      handlers = new ScopeWalk<>(next, TagScope::ownAttachments);
      jobs = new ScopeWalk<>(next, TagScope::ownJobs);
    }
  }

  private void end(TagScope.Attachment handler) {
    handler.stopped(dismissing ? null : scope);
  }

  @Override
  void reach(Job job) {
    TagScope stopped = outermost(job.scope());
    if (stopped != null) {
      TagStop last = unwinding;
      if (last == null || last.scope() != stopped) {
        last = new TagStop(stopped, value);
        unwinding = last;
      }
      if (dismissing) {
        job.abandon(stopped, last);
      } else {
        job.inject(last);
      }
    }
  }

  private @Nullable TagScope outermost(TagScope inner) {
    TagScope found = null;
    for (TagScope each = inner; each != null; each = each.around()) {
      if (each.tag() == tag && concerned.test(each)) {
        found = each;
      }
    }
    return found;
  }
}
