package org.urbi.kernel.job;

import java.util.LinkedHashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/**
 * A light thread of urbiscript (manual, "Job"). Its stack is that of a virtual thread which the
 * tick loop runs; so a switch is an ordinary call that returns later, from anywhere in the
 * interpreter.
 */
public final class Job extends JobFacts implements Runnable {
  /** What a job does. */
  @FunctionalInterface
  public interface Body {
    /** Runs in the job; whatever it throws ends the job. */
    void run(Job job);
  }

  /** What Java code does in less than a millisecond, in steps: see {@link #worked}. */
  private static final int STEPS_BETWEEN_CHECKS = 1 << 16;

  private final Interruptions interruptions;
  private final Body body;
  private final boolean surplus;
  private final @Nullable JobGroup group;
  private final JobThread thread;
  private TagScope scope;
  private JobState state = JobState.RUNNABLE;
  private @Nullable ControlFlowException injected;
  private final JobTime time;
  private @Nullable Set<Runnable> endListeners;

  /** The values of the {@linkplain JobLocal variables} that were set for this job. */
  JobLocal.@Nullable Entry locals;

  /** How many stops made in pieces it has met, or was started after. */
  private int stopsMet;

  /** What Java code has done for it since it last checked, in steps. */
  private int steps;

  private int nonInterruptible;
  private @Nullable ComponentCode componentCode;

  /** Its place among the jobs that can run. */
  final JobList.Link turn = new JobList.Link(this);

  /** Its place among all jobs. */
  final JobList.Link listed = new JobList.Link(this);

  /** Its place among the jobs of its scope. */
  final JobList.Link scoped = new JobList.Link(this);

  /** Its place among the jobs of its group; null if it is in none. */
  final JobList.@Nullable Link grouped;

  Job(
      Scheduler scheduler,
      Body body,
      String prefix,
      UrbiObject lobby,
      TagScope scope,
      @Nullable JobGroup group,
      long timeShift) {
    super(scheduler, prefix, lobby);
    this.interruptions = scheduler.interruptions();
    this.body = body;
    Job creator = scheduler.running();
    this.surplus = !identity.admit(creator);
    this.scope = scope;
    this.group = group;
    this.grouped = group == null ? null : new JobList.Link(this);
    this.thread = scheduler.threads().create(this);
    this.stopsMet = scheduler.stops().begun();
    this.time = new JobTime(this, scope.isFrozen(), timeShift);
    scope.add(this);
    if (creator != null && creator.observer != null) {
      observer = creator.observer.forChild();
    }
    if (creator != null) {
      priority = creator.priority;
    }
  }

  // ------------------------------------------------------------------ its state

  public JobState state() {
    return state;
  }

  /** When it goes on, in nanoseconds of the scheduler; -1 unless it waits for a time. */
  public long deadline() {
    return time.deadline();
  }

  /**
   * Says where the job is about to let others run, until it goes on.
   *
   * @param code where it is
   * @param what of that code it executes; null when nobody knows
   * @return this job
   */
  public Job at(Place code, @Nullable Located what) {
    place = code;
    where = what;
    return this;
  }

  public boolean isFrozen() {
    return time.isFrozen();
  }

  boolean isOf(JobGroup other) {
    return group == other;
  }

  /** Whether it does not wait for anything, not even to be unfrozen. */
  public boolean canRun() {
    return !time.isFrozen() && (state == JobState.RUNNABLE || state == JobState.RUNNING);
  }

  /** The scope of the innermost tagged code that it executes. */
  public TagScope scope() {
    return scope;
  }

  /**
   * The scope of what it begins, jobs and handlers: its own, unless nobody would end them there.
   * Asked in the job.
   */
  public TagScope scopeForNew() {
    if (scope.isAbandoned()) {
      moveTo(TagScope.shelter(scope, this));
    }
    return scope;
  }

  /** How many nanoseconds it has been frozen in all. */
  public long timeShift() {
    return time.shift();
  }

  // ------------------------------------------------------------------ how it runs

  /** The number of surrounding scopes that no other job may interrupt. */
  public int nonInterruptible() {
    return nonInterruptible;
  }

  /** From now on no other job may run. */
  public void refuseInterruption() {
    nonInterruptible++;
    scheduler.yields().endGrant();
  }

  /** Leaves scopes that no other job may interrupt, until only that many remain. */
  public void endNonInterruptible(int before) {
    nonInterruptible = Math.min(nonInterruptible, before);
  }

  // ------------------------------------------------------------------ life, on its own thread

  /** Whether the calling code runs in this job. */
  boolean isCurrentThread() {
    return thread.isCurrent();
  }

  /** The body of the virtual thread. */
  @Override
  public void run() {
    Throwable failure = null;
    try {
      state = JobState.RUNNING;
      checkInjected();
      if (surplus) {
        throw identity.refusal(Resource.JOBS);
      }
      body.run(this);
    } catch (TagStop stop) {
      // The code was stopped: a quiet end.
    } catch (Throwable t) {
      failure = t;
      scheduler.memory().recover(t);
      scheduler.beginTurn();
    }
    end(failure);
  }

  private void end(@Nullable Throwable failure) {
    state = JobState.ENDED;
    injected = null;
    scope.remove(this);
    if (!surplus) {
      budget.giveBack(Resource.JOBS);
    }
    scheduler.ended(this);
    if (scope.isShelterOf(this)) {
      scheduler.attempt(() -> endShelters(scope));
    }
    if (group != null) {
      group.childEnded(this, failure);
    } else if (failure != null) {
      try {
        scheduler.report(this, failure);
      } catch (TagStop stop) {
        // What was thrown tells of itself by code, which was ended as this job was to be.
      }
    }
    if (endListeners != null) {
      endListeners.forEach(scheduler::attempt);
      endListeners = null;
    }
  }

  /** Runs something when the job has ended; at once when it has already. */
  public void onEnd(Runnable listener) {
    if (state == JobState.ENDED) {
      listener.run();
    } else {
      if (endListeners == null) {
        endListeners = new LinkedHashSet<>(2);
      }
      endListeners.add(listener);
    }
  }

  /** Runs that no more when the job ends: whoever has waited for it does so no longer. */
  public void forgetOnEnd(Runnable listener) {
    if (endListeners != null) {
      endListeners.remove(listener);
    }
  }

  /** Lets the others run, if there are any; from code that is nowhere in a source. */
  public void yield() {
    this.yield(null, null);
  }

  /**
   * The separator {@code ;}: lets the others run, if there are any.
   *
   * @param code where it is
   * @param next what of that code it executes next, or has executed last
   */
  public void yield(@Nullable Place code, @Nullable Located next) {
    if (scheduler.yields().passes()) {
      return;
    }
    if (isSpecial() && mustContinue()) {
      checkInjected();
      checkInterrupted();
    } else if (scheduler.hasOthers()) {
      letOthersRun(code, next);
    } else {
      checkInjected();
    }
  }

  /** A stack that is too deep to be put away lets nobody else run, which is no error. */
  private void letOthersRun(@Nullable Place code, @Nullable Located next) {
    if (!interruptions.deepStack().mayBePutAway()) {
      checkInjected();
      checkInterrupted();
      return;
    }
    place = code;
    where = next;
    scheduler.enqueueAgain(this);
    try {
      switchOut();
    } catch (StackOverflowError e) {
      interruptions.deepStack().refused();
    }
  }

  /**
   * Whether a {@code ;} of this job only lets others run: nothing has been asked of it meanwhile.
   */
  boolean needsNoCheckAtYield() {
    return !isSpecial() && injected == null;
  }

  private boolean isSpecial() {
    return (nonInterruptible | Double.doubleToRawLongBits(priority)) != 0;
  }

  /** Lets everybody else who can run do so. */
  public void yieldNow() {
    if (nonInterruptible > 0) {
      if (time.isFrozen()) {
        throw scheduler.refusal(Problem.WAITS_UNINTERRUPTIBLE);
      }
      checkInjected();
      return;
    }
    scheduler.enqueue(this);
    switchOut();
  }

  /** Whether nobody else may run now. */
  private boolean mustContinue() {
    return nonInterruptible > 0 || !scheduler.hasOthersFrom(priority);
  }

  /**
   * Waits until that time of the scheduler, in nanoseconds.
   *
   * @throws RuntimeException in non-interruptible code
   */
  public void sleepUntil(long deadline) {
    if (nonInterruptible > 0) {
      throw scheduler.refusal(Problem.SLEEPS_UNINTERRUPTIBLE);
    }
    time.sleepUntil(deadline);
    state = JobState.SLEEPING;
    wait = Wait.TIME;
    switchOut();
  }

  /**
   * Waits until somebody calls {@link #wake}.
   *
   * @throws RuntimeException in non-interruptible code
   */
  public void waitForWake() {
    waitForWake(Wait.ANOTHER);
  }

  /**
   * Waits until somebody calls {@link #wake}.
   *
   * @param what for what, for those who look
   * @throws RuntimeException in non-interruptible code
   */
  public void waitForWake(Wait what) {
    if (nonInterruptible > 0) {
      throw scheduler.refusal(Problem.WAITS_UNINTERRUPTIBLE);
    }
    state = JobState.WAITING;
    wait = what;
    switchOut();
  }

  private void switchOut() {
    // What others read does not count for the condition that this job is evaluating.
    World world = scheduler.world();
    Dependencies.Tracker tracker = world.tracker;
    world.tracker = null;
    if (observer != null) {
      observer.switchedOut();
    }
    try {
      interruptions.deepStack().refuseAsRecorded();
      thread.suspend();
    } catch (Throwable failure) {
      interruptions.deepStack().failed(failure);
      goOn();
      switchedIn(tracker);
      throw failure;
    }
    switchedIn(tracker);
    checkInjected();
  }

  /** The job goes on at once: takes it out of all queues, so that nothing wakes it later. */
  private void goOn() {
    scheduler.dequeue(this);
    time.endSleep();
  }

  private void switchedIn(Dependencies.@Nullable Tracker tracker) {
    if (observer != null) {
      observer.switchedIn();
    }
    scheduler.world().tracker = tracker;
    state = JobState.RUNNING;
    wait = Wait.TURN;
    place = null;
    where = null;
  }

  /** Throws the exception that other code has injected into this job, if any. */
  public void checkInjected() {
    if (injected != null) {
      ControlFlowException unwinding = injected;
      injected = null;
      throw unwinding;
    }
  }

  /** Whether {@link #checkInterrupted} has to look. */
  public boolean mayBeInterrupted() {
    return interruptions.arePending();
  }

  /**
   * Throws if somebody has asked to end this job; to be called regularly by code that never lets
   * others run.
   */
  public void checkInterrupted() {
    if (mayBeInterrupted()) {
      interruptions.check(this);
    }
  }

  /**
   * Throws if somebody has asked to end this job; for long work in Java, where it costs next to
   * nothing: it looks each time that so much has been done that it may have taken a millisecond.
   *
   * @param more how many steps have been done since it was last called, or are about to be: each of
   *     some nanoseconds, as it takes to look at a number, or at sixteen characters
   */
  public void worked(long more) {
    if (more >= STEPS_BETWEEN_CHECKS - steps) {
      steps = 0;
      checkInterrupted();
    } else {
      steps += (int) more;
    }
  }

  /** The Java code of components that this job executes; in the job. */
  public ComponentCode componentCode() {
    ComponentCode code = componentCode;
    if (code == null) {
      code = new ComponentCode(this, thread);
      componentCode = code;
    }
    return code;
  }

  /** The component function that it executes; null if it executes none. From any thread. */
  public @Nullable String component() {
    ComponentCode code = componentCode;
    return code == null ? null : code.function();
  }

  /** Interrupts such a function if it waits, and that turn still lasts; from any thread. */
  void interruptComponent(long turn) {
    ComponentCode code = componentCode;
    if (code != null) {
      code.interrupt(turn);
    }
  }

  /** The Java calls that it is executing; called from another thread. */
  public StackTraceElement[] stackTrace() {
    return thread.stackTrace();
  }

  // ------------------------------------------------------------------ under tags

  /**
   * Enters code under a tag. When the tag is frozen, waits until it no longer is.
   *
   * @return the scope to give to {@link #leave}
   */
  public TagScope enter(TagState tag) {
    scheduler.number(tag);
    TagScope entered = new TagScope(tag, scopeForNew(), this);
    moveTo(entered);
    return entered;
  }

  /** Leaves tagged code, however it ended. */
  public void leave(TagScope left) {
    TagScope before = scope;
    moveTo(left.parent());
    left.close();
    if (injected instanceof TagStop stop && stop.scope() == left) {
      injected = null;
    }
    endShelters(before);
  }

  /** It has left that scope: what it has begun there for cleaning up ends. */
  private void endShelters(TagScope before) {
    for (TagScope each = before; each.isShelterOf(this); each = each.parent()) {
      each.endShelter(scheduler);
    }
  }

  private void moveTo(TagScope other) {
    scope.remove(this);
    other.add(this);
    scope = other;
    followTags();
  }

  /** Suspends this job if it has just been frozen, by itself or by the code it entered. */
  public void waitWhileFrozen() {
    if (time.isFrozen()) {
      yieldNow();
    }
  }

  /** Suspends this job alone, whatever its tags do, until {@link #unfreezeAlone}. */
  public void freezeAlone() {
    time.setFrozenAlone(true);
  }

  /** Ends what {@link #freezeAlone} has begun. */
  public void unfreezeAlone() {
    time.setFrozenAlone(false);
  }

  /** A tag was frozen or no longer is, or the job has come under other ones. */
  void followTags() {
    time.setFrozenByTags(scope.isFrozen());
  }

  /**
   * Ends what it executes in that scope for good: see {@link TagScope#isAbandoned}. It cleans up,
   * and whoever has frozen it keeps it no longer from that.
   */
  void abandon(TagScope stopped, TagStop unwinding) {
    inject(unwinding);
    scope.abandonShelters(stopped);
    time.unfreeze();
  }

  // ------------------------------------------------------------------ from the outside

  /** Ends its wait. */
  public void wake() {
    if (state == JobState.WAITING) {
      makeRunnable();
    }
  }

  /** Ends the wait of the job, and queues it. */
  void makeRunnable() {
    state = JobState.RUNNABLE;
    scheduler.enqueue(this);
  }

  /**
   * Throws an exception in the job as soon as its turn comes; if it is running, at its next {@link
   * #checkInjected}. Of two stops the outer one wins.
   */
  void inject(ControlFlowException unwinding) {
    if (state == JobState.ENDED) {
      return;
    }
    meetStops();
    if (injected == null || unwinding instanceof TagStop stop && stop.isOuter(injected)) {
      injected = unwinding;
      scheduler.yields().endGrant();
    }
    if (state == JobState.SLEEPING || state == JobState.WAITING) {
      makeRunnable();
    } else if (time.release()) {
      scheduler.enqueue(this);
    }
    time.endSleep();
  }

  /** Drops a failure reported by that group, for which nobody waits any more. */
  void forget(JobGroup left) {
    if (injected instanceof ChildFailure failure && failure.group() == left) {
      injected = null;
    }
  }

  /** Ends the job, wherever it is. */
  public void terminate() {
    inject(TagStop.WHOLE_JOB);
  }

  /** Ends what this job executes, after a stop that meets very many jobs one after the other. */
  void meetStops() {
    int met = stopsMet;
    Stops stops = scheduler.stops();
    if (met != stops.begun()) {
      stopsMet = stops.begun();
      stops.meet(this, met);
    }
  }

  /** The turn of the job; called by the tick loop alone. */
  void resume() {
    if (state == JobState.ENDED) {
      return;
    }
    meetStops();
    if (time.isFrozen() && injected == null) {
      time.hold();
      return;
    }
    thread.resume();
  }
}
