package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;

/**
 * What others ask of a job: which it is, for whom it runs, and where it stands. It is part of the
 * job itself, and no object beside it, because each switch notes something here.
 */
abstract sealed class JobFacts permits Job {
  /** Jobs in more nested calls than that tell so. */
  public static final int DEEP = 60_000;

  final Scheduler scheduler;
  final JobIdentity identity;

  /** Each turn asks for it: found without a look at {@link #identity}. */
  final Budget budget;

  /** What its name begins with. */
  final String prefix;

  private final long number;
  private final long starter;
  private boolean daemon;
  private int deepest;
  private int nestedSends;
  double priority;

  Wait wait = Wait.TURN;
  @Nullable Place place;
  @Nullable Located where;
  @Nullable JobObserver observer;

  /** What is measured of it; null while nobody has looked. */
  TurnMeter.@Nullable Measures measures;

  JobFacts(Scheduler scheduler, String prefix, UrbiObject lobby) {
    this.scheduler = scheduler;
    this.number = scheduler.nextNumber();
    Job creator = scheduler.running();
    this.starter = creator == null ? 0 : creator.number();
    this.prefix = prefix;
    this.identity = new JobIdentity(scheduler, lobby);
    this.budget = identity.budget();
  }

  // ------------------------------------------------------------------ what it is

  public Scheduler scheduler() {
    return scheduler;
  }

  /**
   * A number that no other job of the kernel has; jobs that were started later have greater ones.
   */
  public long number() {
    return number;
  }

  public String name() {
    return prefix + "_" + number;
  }

  /** The number of the job that was running when this one was started; 0 when there was none. */
  public long starter() {
    return starter;
  }

  /** The lobby for which the job runs, and to which its output goes. */
  public UrbiObject lobby() {
    return identity.lobby();
  }

  /** What it may do, and use, for that lobby. */
  public JobIdentity identity() {
    return identity;
  }

  /** Whether it may do everything. */
  public boolean isOwner() {
    return identity.role() == Role.OWNER;
  }

  /** The budget that it uses: that of its first lobby. */
  public Budget budget() {
    return budget;
  }

  /** Whose turn it is when it runs. */
  Budget account() {
    return budget.account();
  }

  /**
   * Whether it only waits for somebody to send something, so that it does not keep the kernel
   * running.
   */
  public boolean isDaemon() {
    return daemon;
  }

  /** See {@link #isDaemon}. */
  public void setDaemon(boolean on) {
    daemon = on;
  }

  /** Jobs of a lower priority do not run while this one can; usually 0. */
  public double priority() {
    return priority;
  }

  public void setPriority(double other) {
    priority = other;
    scheduler.yields().endGrant();
  }

  // ------------------------------------------------------------------ where it stands

  /** Tells that the job is in that many nested calls; called for each beyond {@link #DEEP}. */
  public void noteCalls(int nested) {
    deepest = Math.max(deepest, nested);
    // It may have said where it is, and then not let others run.
    place = null;
    where = null;
  }

  /** Its stack has been put away, so it is in few calls now. */
  void forgetCalls() {
    if (deepest != 0) {
      deepest = 0;
    }
  }

  /**
   * How many nested calls it is in, as it lets others run, at most: where nobody has said where it
   * is, it may have left the deepest of them.
   */
  int calls() {
    if (place != null) {
      deepest = place.depth();
    }
    return deepest;
  }

  /**
   * Java code is about to send a message to urbiscript.
   *
   * @param most how deeply such messages may be nested
   * @return false, and nothing has begun, if the limit is reached
   */
  public boolean beginSend(int most) {
    if (nestedSends >= most) {
      return false;
    }
    nestedSends++;
    return true;
  }

  /** Ends what {@link #beginSend} has begun. */
  public void endSend() {
    nestedSends--;
  }

  /** What it waits for. */
  public Wait waitsFor() {
    return wait;
  }

  /** The code in which it lets others run; null when it runs, and when nobody has said. */
  public @Nullable Place place() {
    return place;
  }

  /** What of that code it executes. */
  public @Nullable Located where() {
    return where;
  }

  /** Who measures what this job does; usually null. */
  public @Nullable JobObserver observer() {
    return observer;
  }

  /** Sets the observer of this job; null for none. */
  public void observe(@Nullable JobObserver by) {
    observer = by;
  }
}
