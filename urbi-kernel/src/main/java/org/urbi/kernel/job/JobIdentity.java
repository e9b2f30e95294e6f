package org.urbi.kernel.job;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;
import org.urbi.kernel.trust.RoleHolder;

/** The lobby for which a job runs, what the job may do there, and what it may use. */
public final class JobIdentity {
  private final Scheduler scheduler;
  private final Budget budget;
  private UrbiObject lobby;
  private Role role;

  JobIdentity(Scheduler scheduler, UrbiObject lobby) {
    this.scheduler = scheduler;
    this.budget = scheduler.budgetOf(lobby);
    this.lobby = lobby;
    this.role = RoleHolder.roleOf(lobby);
  }

  /**
   * Takes a job from the budget. If the lobby has too many, the exception is thrown in the job that
   * starts the new one. If that job belongs to another lobby, or there is none, the new job is to
   * get the exception as soon as it runs.
   *
   * @return whether it has been taken
   */
  boolean admit(@Nullable Job creator) {
    boolean admitted = budget.take(Resource.JOBS);
    if (!admitted && creator != null && creator.budget() == budget) {
      throw refusal(Resource.JOBS);
    }
    return admitted;
  }

  UrbiObject lobby() {
    return lobby;
  }

  Budget budget() {
    return budget;
  }

  /** What the job may do: the role of its lobby. */
  public Role role() {
    return role;
  }

  /**
   * Whether that lobby may do less than the job: its code must not hold up the job, or end it, when
   * the job sets it off.
   */
  public boolean isAbove(UrbiObject other) {
    return RoleHolder.roleOf(other).compareTo(role) < 0;
  }

  /**
   * Whether unevaluated arguments of the job's code may be evaluated for that lobby: they must not
   * have the permissions of a more privileged one, which only code of that lobby may have.
   */
  public boolean mayLendArgumentsTo(UrbiObject other) {
    return role == Role.OWNER || isAbove(other);
  }

  /** From now on the job runs for another lobby; its budget remains. */
  public void become(UrbiObject other) {
    lobby = other;
    role = RoleHolder.roleOf(other);
  }

  /**
   * Runs an action on behalf of another lobby, if that lobby has other permissions than the job's
   * own.
   */
  public <T> T doFor(UrbiObject other, Supplier<T> action) {
    if (other == lobby || role == Role.OWNER && RoleHolder.roleOf(other) == Role.OWNER) {
      return action.get();
    }
    UrbiObject own = lobby;
    become(other);
    try {
      return action.get();
    } finally {
      become(own);
    }
  }

  /**
   * Takes one unit of a limited resource.
   *
   * @throws RuntimeException if that would be too much
   */
  public void take(Resource what) {
    if (!budget.take(what)) {
      throw refusal(what);
    }
  }

  /** The exception for code that needs a resource when the budget is exhausted. */
  public RuntimeException refusal(Resource what) {
    return scheduler.refusal(Problem.BUDGET_EXHAUSTED, budget.limit(what), what.unit());
  }
}
