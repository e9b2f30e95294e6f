package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/** An object (a lobby) whose code the kernel calls in jobs that nobody's code has started. */
public interface JobOwner {
  /** Labels all the code that ends with it; null if it never ends. */
  @Nullable TagState lifeTag();

  /** Whether that code has been ended for good: its client has left. */
  boolean hasLeft();

  /**
   * Starts a job in which code of a lobby is called: a hook, a condition. It ends with the lobby as
   * all its code does, together with what the code begins, so that nothing escapes from whoever
   * ends that. Code that is called when the lobby has ended, as hooks are that stay behind, does
   * what it has to do; but what it begins ends with it.
   */
  static Job start(Scheduler scheduler, UrbiObject lobby, String prefix, Job.Body body) {
    TagState tag = lobby instanceof JobOwner owner ? owner.lifeTag() : null;
    if (tag == null) {
      return scheduler.startDetached(lobby, scheduler.rootScope(), prefix, body);
    }
    TagScope scope = TagScope.branch(scheduler, tag, scheduler.rootScope());
    if (((JobOwner) lobby).hasLeft()) {
      scope.abandon();
    }
    try {
      return scheduler.startDetached(lobby, scope, prefix, body);
    } finally {
      scope.end();
    }
  }
}
