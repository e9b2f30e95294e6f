package org.urbi.kernel.node;

import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;

/** Refuses what the lobby of the running code is not permitted to do. */
public final class PermissionCheck {
  private PermissionCheck() {}

  /** Whether the caller may change an object: its slots, its prototypes, its content. */
  public static boolean allowsChange(Frame caller, UrbiObject target) {
    return allowsChange(caller.job, target);
  }

  /** Whether a job may change an object: its slots, its prototypes, its content. */
  static boolean allowsChange(Job job, UrbiObject target) {
    return allowsChange(job.identity().role(), job.lobby(), target);
  }

  /** Whether code of that role, which runs for that lobby, may change an object. */
  public static boolean allowsChange(Role role, UrbiObject lobby, UrbiObject target) {
    if (role == Role.OWNER) {
      return true;
    }
    UrbiObject ownerLobby = target.ownerLobby();
    return ownerLobby == null ? role == Role.USER : ownerLobby == lobby;
  }

  /** Whether code of that role, which runs for that lobby, may change a job. */
  public static boolean allowsChange(Role role, UrbiObject lobby, Job target) {
    return role == Role.OWNER || target.lobby() == lobby;
  }

  /**
   * Refuses to change an object if the job of the caller may not.
   *
   * @param routine the function that would change it
   */
  public static void checkChange(Frame caller, String routine, UrbiObject target) {
    if (allowsChange(caller.job, target)) {
      return;
    }
    UrbiObject ownerLobby = target.ownerLobby();
    if (ownerLobby == null) {
      throw refused(caller, routine, Problem.CHANGES_FOREIGN, Role.USER);
    }
    boolean systems = ownerLobby == caller.interpreter.values().object;
    throw refused(
        caller, routine, systems ? Problem.CHANGES_SYSTEM : Problem.CHANGES_LOBBY, Role.OWNER);
  }

  /** Refuses to change a job, unless it runs for the lobby of the caller. */
  public static void checkChange(Frame caller, String routine, Job target) {
    if (!allowsChange(caller.job.identity().role(), caller.job.lobby(), target)) {
      throw refused(caller, routine, Problem.CHANGES_JOB, Role.OWNER);
    }
  }

  /**
   * Whether code of that role, which runs for that lobby, may end or suspend what is under a tag.
   */
  public static boolean allowsControl(Role role, UrbiObject lobby, TagState tag) {
    return role == Role.OWNER || tag.isOnlyOf(lobby);
  }

  /**
   * Refuses to end or suspend what is under a tag, unless all of it runs for the caller's lobby.
   */
  public static void checkControl(Frame caller, String routine, TagState tag) {
    if (!allowsControl(caller.job.identity().role(), caller.job.lobby(), tag)) {
      throw refused(caller, routine, Problem.CHANGES_JOB, Role.OWNER);
    }
  }

  /** Makes a new object the own of the lobby whose code has made it: only that may change it. */
  public static void claim(Frame maker, UrbiObject made) {
    if (made.ownerLobby() == null) {
      made.setOwnerLobby(maker.job.lobby());
    }
  }

  /** Makes an object the system's own, with what its slots hold: only owners may change it. */
  public static void claimForSystem(UrbiObject made) {
    UrbiObject system = made.world().values().object;
    made.setOwnerLobby(system);
    for (UrbiObject value : made.localSlotValues()) {
      if (!(value instanceof Code)) {
        value.setOwnerLobby(system);
      }
    }
  }

  /** Refuses what needs a higher role than the caller's. */
  public static void checkRole(Frame caller, String routine, Role least) {
    if (caller.job.identity().role().compareTo(least) < 0) {
      throw refused(caller, routine, Problem.NEEDS_ROLE, least);
    }
  }

  /** Makes a new object the observer's own: only that lobby may change it. */
  public static void claimForObserver(Frame maker, UrbiObject made) {
    if (maker.job.identity().role() == Role.OBSERVER) {
      claim(maker, made);
    }
  }

  private static UrbiException refused(Frame caller, String routine, Problem problem, Role needed) {
    return caller
        .interpreter
        .errors()
        .primitive(routine, problem, needed.text(), caller.job.identity().role().text());
  }
}
