package org.urbi.kernel.observe;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;

/**
 * Controls jobs and tags for people who look at them, as far as the role of their lobby allows. On
 * the kernel thread, between the turns.
 */
public final class Steering {
  /** What can be done. */
  public enum Action {
    /** Ends a job, or all that runs under a tag. */
    STOP,
    /** Suspends a job, or all that runs under a tag. */
    FREEZE,
    /** Lets what was frozen go on. */
    UNFREEZE,
    /** Ends all that runs under a tag, and lets nothing begin. */
    BLOCK,
    /** Lets code under a tag begin again. */
    UNBLOCK;

    private final String text = name().toLowerCase(Locale.ROOT);

    /** As urbiscript names it. */
    public String text() {
      return text;
    }

    /** The action of that name; null if there is none. */
    public static @Nullable Action of(String name) {
      for (Action action : values()) {
        if (action.text.equals(name)) {
          return action;
        }
      }
      return null;
    }
  }

  private final Scheduler scheduler;
  private final UrbiObject nothing;

  /** The tags that were frozen or blocked here: nothing need be under them. */
  private final Map<Long, TagState> held = new HashMap<>();

  /**
   * @param nothing the value of what is stopped: void
   */
  public Steering(Scheduler scheduler, UrbiObject nothing) {
    this.scheduler = scheduler;
    this.nothing = nothing;
  }

  /**
   * Does something to a job.
   *
   * @param by the lobby of who wants it
   * @return why it cannot be done; empty when it was
   */
  public String steerJob(UrbiLobby by, Action action, long number) {
    Job job = null;
    for (Job each : scheduler.jobs()) {
      if (each.number() == number) {
        job = each;
      }
    }
    if (job == null) {
      return Problem.NO_SUCH_JOB.text(number);
    }
    if (!PermissionCheck.allowsChange(by.role(), by, job)) {
      return Problem.CHANGES_JOB.text(Role.OWNER.text(), by.role().text());
    }
    switch (action) {
      case STOP -> job.terminate();
      case FREEZE -> job.freezeAlone();
      case UNFREEZE -> job.unfreezeAlone();
      case BLOCK, UNBLOCK -> {
        return Problem.BLOCKS_JOB.text();
      }
    }
    return "";
  }

  /**
   * Does something to a tag.
   *
   * @param by the lobby of who wants it
   * @return why it cannot be done; empty when it was
   */
  public String steerTag(UrbiLobby by, Action action, long number) {
    TagState tag = held.containsKey(number) ? held.get(number) : scheduler.rootScope().tag(number);
    UrbiObject owner = tag == null ? null : tag.owner();
    if (tag == null || owner == null) {
      return Problem.NO_SUCH_TAG.text(number);
    }
    if (!PermissionCheck.allowsChange(by.role(), by, owner)) {
      return refusal(by.role(), owner);
    }
    if (action != Action.UNFREEZE
        && action != Action.UNBLOCK
        && !PermissionCheck.allowsControl(by.role(), by, tag)) {
      return Problem.CHANGES_JOB.text(Role.OWNER.text(), by.role().text());
    }
    switch (action) {
      case STOP -> tag.stop(scheduler, nothing);
      case FREEZE -> tag.freeze();
      case UNFREEZE -> tag.unfreeze();
      case BLOCK -> tag.block(scheduler, nothing);
      case UNBLOCK -> tag.unblock();
    }
    if (tag.isFrozen() || tag.isBlocked()) {
      held.put(number, tag);
    } else {
      held.remove(number);
    }
    return "";
  }

  private static String refusal(Role role, UrbiObject target) {
    return target.ownerLobby() == null
        ? Problem.CHANGES_FOREIGN.text(Role.USER.text(), role.text())
        : Problem.CHANGES_LOBBY.text(Role.OWNER.text(), role.text());
  }
}
