package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;
import org.urbi.kernel.trust.RoleHolder;
import org.urbi.lang.source.Span;

/**
 * A light thread of urbiscript (manual, "Job"). Its stack is that of a virtual thread which the
 * tick loop runs; so a switch is an ordinary call that returns later, from anywhere in the
 * interpreter.
 */
public final class Job implements Runnable {
  /** What a job does. */
  @FunctionalInterface
  public interface Body {
    /** Runs in the job; whatever it throws ends the job. */
    void run(Job job);
  }

  /** The states of a job. */
  public enum State {
    RUNNABLE("running"),
    RUNNING("running"),
    WAITING("waiting"),
    SLEEPING("sleeping"),
    ENDED("terminated");

    private final String text;

    State(String text) {
      this.text = text;
    }

    /** As the manual names it. */
    public String text() {
      return text;
    }
  }

  private final Scheduler scheduler;
  private final Interruptions interruptions;
  private final Body body;
  private final long number;
  private final String prefix;
  private UrbiObject lobby;
  private Role role;
  private final Budget budget;
  private final boolean surplus;
  private final @Nullable JobGroup group;
  private final JobThread thread;
  private boolean daemon;
  private TagScope scope;
  private State state = State.RUNNABLE;
  private @Nullable ControlFlowException injected;
  private Timers.@Nullable Timer timer;
  private Wait wait = Wait.TURN;
  private @Nullable Place place;
  private @Nullable Located where;
  private final long starter;
  private long ran;
  private long waker;
  private int tracers;
  private boolean frozenAlone;
  private int frozenDepth;
  private boolean heldByFreeze;
  private long frozenSince;
  private long sleepLeft;
  private long timeShift;
  private @Nullable List<Runnable> endListeners;

  /** The values of the {@linkplain JobLocal variables} that were set for this job. */
  JobLocal.@Nullable Entry locals;

  /** Measures what a job does. */
  public interface Observer {
    /** The job lets others run. */
    void switchedOut();

    /** It is the job's turn again. */
    void switchedIn();

    /** The observer of a job that this one starts. */
    Observer forChild();
  }

  private @Nullable Observer observer;
  private int nestedSends;
  private int redefinitions;
  private int nonInterruptible;
  private double priority;
  private final ComponentCode componentCode;

  /** Its place among the jobs that can run. */
  final JobList.Link turn = new JobList.Link(this);

  /** Its place among all jobs. */
  final JobList.Link listed = new JobList.Link(this);

  /** Its place among the jobs of its scope. */
  final JobList.Link scoped = new JobList.Link(this);

  /** Its place among the jobs of its group. */
  final JobList.Link grouped = new JobList.Link(this);

  Job(
      Scheduler scheduler,
      Body body,
      String prefix,
      UrbiObject lobby,
      TagScope scope,
      @Nullable JobGroup group,
      long timeShift) {
    this.scheduler = scheduler;
    this.interruptions = scheduler.interruptions();
    this.body = body;
    this.number = scheduler.nextNumber();
    Job creator = scheduler.running();
    this.starter = creator == null ? 0 : creator.number;
    this.prefix = prefix;
    this.lobby = lobby;
    this.role = RoleHolder.roleOf(lobby);
    this.budget = scheduler.budgetOf(lobby);
    this.surplus = !isAdmitted(creator);
    this.scope = scope;
    this.group = group;
    this.timeShift = timeShift;
    this.thread = scheduler.newThread(this);
    this.componentCode = new ComponentCode(this, thread);
    this.frozenDepth = scope.frozenDepth();
    this.frozenSince = scheduler.now();
    scope.add(this);
    if (creator != null && creator.observer != null) {
      observer = creator.observer.forChild();
    }
    if (creator != null) {
      priority = creator.priority;
    }
  }

  /**
   * If the lobby has too many jobs, the exception is thrown in the job that starts this one. If
   * that job belongs to another lobby, or there is none, the new job gets the exception as soon as
   * it runs.
   */
  private boolean isAdmitted(@Nullable Job creator) {
    boolean admitted = budget.take(Resource.JOBS);
    if (!admitted && creator != null && creator.budget == budget) {
      throw refusal(Resource.JOBS);
    }
    return admitted;
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

  /** The lobby for which the job runs, and to which its output goes. */
  public UrbiObject lobby() {
    return lobby;
  }

  /** From now on it runs for another lobby. */
  public void runFor(UrbiObject other) {
    lobby = other;
    role = RoleHolder.roleOf(other);
  }

  /** What it may do: the role of its lobby. */
  public Role role() {
    return role;
  }

  /** Whether it may do everything. */
  public boolean isOwner() {
    return role == Role.OWNER;
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
   * Takes one unit of a limited resource of its lobby.
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

  /**
   * Runs an action on behalf of another lobby, if that lobby has other permissions than the job's
   * own.
   */
  public <T> T doFor(UrbiObject other, Supplier<T> action) {
    if (other == lobby || role == Role.OWNER && RoleHolder.roleOf(other) == Role.OWNER) {
      return action.get();
    }
    UrbiObject own = lobby;
    runFor(other);
    try {
      return action.get();
    } finally {
      runFor(own);
    }
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

  public State state() {
    return state;
  }

  // ------------------------------------------------------------------ for those who look

  /** Code of a job that has called other code. */
  public interface Place {
    /** The calls that lead to the code, innermost first. */
    List<UrbiException.Call> backtrace();
  }

  /** What was written somewhere. */
  @FunctionalInterface
  public interface Located {
    /** Where it was written; null when nobody knows. */
    @Nullable Span span();
  }

  /** The number of the job that was running when this one was started; 0 when there was none. */
  public long starter() {
    return starter;
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

  /** When it goes on, in nanoseconds of the scheduler; -1 unless it waits for a time. */
  public long deadline() {
    return timer == null ? -1 : timer.deadline();
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

  /** How long its turns have lasted while somebody looked, in nanoseconds. */
  public long ran() {
    return ran;
  }

  void charge(long nanoseconds) {
    ran += nanoseconds;
  }

  /** Who has made it runnable: the number of a job; 0 for the time, or something outside. */
  long waker() {
    return waker;
  }

  void wokenBy(long job) {
    waker = job;
  }

  /** Whether its turns are kept, because somebody looks at them. */
  boolean isTraced() {
    return tracers > 0;
  }

  /**
   * One more wants to see its turns; to be called between {@link Scheduler#beginObservation} and
   * its end.
   */
  public void beginTrace() {
    tracers++;
  }

  /** Ends one {@link #beginTrace}. */
  public void endTrace() {
    tracers--;
  }

  public boolean isFrozen() {
    return frozenDepth > 0;
  }

  /** Whether it does not wait for anything, not even to be unfrozen. */
  public boolean canRun() {
    return frozenDepth == 0 && (state == State.RUNNABLE || state == State.RUNNING);
  }

  /** The scope of the innermost tagged code that it executes. */
  public TagScope scope() {
    return scope;
  }

  /** How many nanoseconds it has been frozen in all. */
  public long timeShift() {
    return timeShift;
  }

  // ------------------------------------------------------------------ how it runs

  /** Who measures what this job does; usually null. */
  public @Nullable Observer observer() {
    return observer;
  }

  /** Sets the observer of this job; null for none. */
  public void observe(@Nullable Observer by) {
    observer = by;
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

  /** The number of surrounding scopes in which slots may be redefined. */
  public int redefinitions() {
    return redefinitions;
  }

  /** Allows slots to be redefined from now on. */
  public void allowRedefinition() {
    redefinitions++;
  }

  /** Leaves scopes in which slots may be redefined, until only that many remain. */
  public void endRedefinitions(int before) {
    redefinitions = Math.min(redefinitions, before);
  }

  /** The number of surrounding scopes that no other job may interrupt. */
  public int nonInterruptible() {
    return nonInterruptible;
  }

  /** From now on no other job may run. */
  public void refuseInterruption() {
    nonInterruptible++;
  }

  /** Leaves scopes that no other job may interrupt, until only that many remain. */
  public void endNonInterruptible(int before) {
    nonInterruptible = Math.min(nonInterruptible, before);
  }

  /** Jobs of a lower priority do not run while this one can; usually 0. */
  public double priority() {
    return priority;
  }

  public void setPriority(double other) {
    priority = other;
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
      state = State.RUNNING;
      checkInjected();
      if (surplus) {
        throw refusal(Resource.JOBS);
      }
      body.run(this);
    } catch (TagStop stop) {
      // The code was stopped: a quiet end.
    } catch (Throwable t) {
      failure = t;
      scheduler.recover(t);
    }
    end(failure);
  }

  private void end(@Nullable Throwable failure) {
    state = State.ENDED;
    injected = null;
    scope.remove(this);
    if (!surplus) {
      budget.giveBack(Resource.JOBS);
    }
    scheduler.ended(this);
    if (group != null) {
      group.childEnded(this, failure);
    } else if (failure != null) {
      scheduler.report(this, failure);
    }
    if (endListeners != null) {
      endListeners.forEach(scheduler::attempt);
    }
  }

  /** Runs something when the job has ended; at once when it has already. */
  public void onEnd(Runnable listener) {
    if (state == State.ENDED) {
      listener.run();
    } else {
      if (endListeners == null) {
        endListeners = new ArrayList<>(2);
      }
      endListeners.add(listener);
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
    if ((nonInterruptible | Double.doubleToRawLongBits(priority)) != 0 && mustContinue()) {
      checkInjected();
      checkInterrupted();
    } else if (scheduler.hasOthers()) {
      place = code;
      where = next;
      yieldNow();
    } else {
      checkInjected();
    }
  }

  /** Lets everybody else who can run do so. */
  public void yieldNow() {
    if (nonInterruptible > 0) {
      if (frozenDepth > 0) {
        throw scheduler.refusal(Problem.WAITS_UNINTERRUPTIBLE);
      }
      checkInjected();
      return;
    }
    scheduler.enqueue(this);
    switchOut();
  }

  /**
   * To be called while an exception unwinds many calls, which takes long: lets others run if there
   * are any.
   */
  public void yieldWhileUnwinding() {
    if (nonInterruptible > 0) {
      return;
    }
    // The number of the turn changes even if nobody else runs, so the state of ending this job is
    // carried over.
    Interruptions.Termination termination = scheduler.interruptions().pause();
    try {
      if (scheduler.hasOthers()) {
        yieldNow();
      }
    } finally {
      scheduler.interruptions().resume(termination);
    }
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
    timer = scheduler.timers().addUncounted(deadline, this::onTimer);
    state = State.SLEEPING;
    wait = Wait.TIME;
    switchOut();
  }

  private void onTimer() {
    timer = null;
    makeRunnable();
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
    state = State.WAITING;
    wait = what;
    switchOut();
  }

  private void switchOut() {
    // What others read does not count for the condition that this job is evaluating.
    Dependencies.Tracker tracker = scheduler.world().tracker;
    scheduler.world().tracker = null;
    if (observer != null) {
      observer.switchedOut();
    }
    try {
      thread.suspend();
    } catch (Throwable failure) {
      // It goes on running, so nothing must wake it.
      scheduler.dequeue(this);
      cancelTimer();
      throw failure;
    } finally {
      if (observer != null) {
        observer.switchedIn();
      }
      scheduler.world().tracker = tracker;
      state = State.RUNNING;
      wait = Wait.TURN;
      place = null;
      where = null;
    }
    checkInjected();
  }

  /** Throws the exception that other code has injected into this job, if any. */
  public void checkInjected() {
    if (injected != null) {
      ControlFlowException unwinding = injected;
      injected = null;
      throw unwinding;
    }
  }

  /**
   * Throws if somebody has asked to end this job; to be called regularly by code that never lets
   * others run.
   */
  public void checkInterrupted() {
    if (interruptions.arePending()) {
      interruptions.check(this);
    }
  }

  /** The Java code of components that this job executes. */
  public ComponentCode componentCode() {
    return componentCode;
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
    TagScope entered = new TagScope(tag, scope, this);
    moveTo(entered);
    return entered;
  }

  /** Leaves tagged code, however it ended. */
  public void leave(TagScope left) {
    moveTo(left.parent());
    left.close();
    if (injected instanceof TagStop stop && stop.scope() == left) {
      injected = null;
    }
  }

  /** A scope under a tag, for other jobs; to be {@linkplain TagScope#end ended}. */
  public TagScope branch(TagState tag, TagScope around) {
    scheduler.number(tag);
    return new TagScope(tag, around, null);
  }

  private void moveTo(TagScope other) {
    scope.remove(this);
    other.add(this);
    scope = other;
    int depth = other.frozenDepth() + (frozenAlone ? 1 : 0);
    if (depth > 0 && frozenDepth == 0) {
      frozenSince = scheduler.now();
    }
    frozenDepth = depth;
  }

  /** Suspends this job if it has just been frozen, by itself or by the code it entered. */
  public void waitWhileFrozen() {
    if (frozenDepth > 0) {
      yieldNow();
    }
  }

  /** Suspends this job alone, whatever its tags do, until {@link #unfreezeAlone}. */
  public void freezeAlone() {
    if (!frozenAlone) {
      frozenAlone = true;
      freeze();
    }
  }

  /** Ends what {@link #freezeAlone} has begun. */
  public void unfreezeAlone() {
    if (frozenAlone) {
      frozenAlone = false;
      unfreeze();
    }
  }

  void freeze() {
    if (frozenDepth++ == 0) {
      frozenSince = scheduler.now();
      if (timer != null) {
        sleepLeft = timer.deadline() - frozenSince;
        timer.cancel();
      }
    }
  }

  void unfreeze() {
    if (--frozenDepth == 0) {
      timeShift += scheduler.now() - frozenSince;
      if (state == State.SLEEPING) {
        timer =
            scheduler.timers().moved(runningTimer(), scheduler.now() + sleepLeft, this::onTimer);
      } else if (heldByFreeze) {
        heldByFreeze = false;
        scheduler.enqueue(this);
      }
    }
  }

  private Timers.Timer runningTimer() {
    return requireNonNull(timer, "who sleeps has one");
  }

  // ------------------------------------------------------------------ from the outside

  /** Ends its wait. */
  public void wake() {
    if (state == State.WAITING) {
      makeRunnable();
    }
  }

  /**
   * The thread of the job waits inside Java, for instance for a lock that another thread holds.
   * That takes real time, which simulated time must not outrun.
   */
  void waitsInJava() {
    scheduler.pace().begin();
  }

  /** The JDK lets the thread of this job continue. */
  void wakeFromOutside() {
    scheduler.pace().end();
    scheduler.enqueue(this);
  }

  private void makeRunnable() {
    state = State.RUNNABLE;
    scheduler.enqueue(this);
  }

  /**
   * Throws an exception in the job as soon as its turn comes; if it is running, at its next {@link
   * #checkInjected}. Of two stops the outer one wins.
   */
  void inject(ControlFlowException unwinding) {
    if (state == State.ENDED) {
      return;
    }
    if (injected == null || isOuter(unwinding)) {
      injected = unwinding;
    }
    if (state == State.SLEEPING || state == State.WAITING) {
      makeRunnable();
    } else if (heldByFreeze) {
      heldByFreeze = false;
      scheduler.enqueue(this);
    }
    cancelTimer();
  }

  private void cancelTimer() {
    Timers.Timer sleep = timer;
    if (sleep != null) {
      timer = null;
      sleep.cancel();
    }
  }

  private boolean isOuter(ControlFlowException unwinding) {
    if (!(unwinding instanceof TagStop stop)) {
      return false;
    }
    if (stop.scope() == null || !(injected instanceof TagStop known)) {
      return true;
    }
    return known.scope() != null && stop.scope().depth() < known.scope().depth();
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

  /** The turn of the job; called by the tick loop alone. */
  void resume() {
    if (state == State.ENDED) {
      return;
    }
    if (frozenDepth > 0 && injected == null) {
      heldByFreeze = true;
      return;
    }
    thread.resume();
  }
}
