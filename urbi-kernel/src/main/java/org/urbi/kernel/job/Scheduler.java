package org.urbi.kernel.job;

import java.lang.invoke.VarHandle;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Budgeted;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;

/**
 * The tick loop. A tick reads the clock, takes the inbox, fires the timers that are due, and runs
 * every runnable job once, in the order in which they became runnable. It runs on the kernel
 * thread, the only one to touch urbiscript objects.
 */
public final class Scheduler {
  /** How many turns the jobs get for ending when the kernel ends. */
  private static final int LAST_ROUNDS = 1000;

  private final World world;
  private final Clock clock;
  private final Clock machine;
  private volatile @Nullable Thread loop;
  private final Inbox inbox;
  private final Journal journal;
  private final boolean counted;
  private final TickTime time;
  private final Timers timers = new Timers(this::admitTimer);
  private final Budget common = new Budget();
  private final UsageMeter meter;
  private final Observation observation;
  private final SimulationPace pace;
  private final MemoryWait memory;
  private final Interruptions interruptions;
  private final JobThread.Factory threads;
  private final RunQueue runnable;
  private final StartedJobs started;
  private final Rounds rounds;
  private final JobList jobs = new JobList();
  private final TagScope rootScope = new TagScope();
  private final Stops stops = new Stops(this);
  private final EndOfTick endOfTick = new EndOfTick();
  private final BiConsumer<Job, Throwable> uncaught;
  private BiFunction<Problem, Object[], RuntimeException> refusals =
      (problem, places) -> new IllegalStateException(problem.text(places));
  private final AtomicLong turns = new AtomicLong();
  private final YieldCount yields;
  private @Nullable Job running;
  private boolean stopped;
  private volatile boolean over;
  private long sequence;
  private long tagSequence;

  /**
   * @param journal records all input from outside
   * @param uncaught called with a job for which nobody waits and the exception that ended it; with
   *     null for an exception thrown between the turns of the jobs
   */
  public Scheduler(
      World world,
      Clock clock,
      Journal journal,
      JobThreads threads,
      BiConsumer<Job, Throwable> uncaught) {
    this(world, clock, new SystemClock(), journal, threads, uncaught);
  }

  /**
   * @param machine the real time, which goes on while simulated time stands still
   */
  Scheduler(
      World world,
      Clock clock,
      Clock machine,
      Journal journal,
      JobThreads threads,
      BiConsumer<Job, Throwable> uncaught) {
    this.world = world;
    this.machine = machine;
    this.observation = new Observation(machine);
    this.journal = journal;
    this.counted = journal.countsChecks();
    this.inbox = new Inbox(journal);
    this.yields = new YieldCount(inbox);
    this.interruptions = new Interruptions(this::turn, journal, machine);
    this.clock = clock;
    this.pace = new SimulationPace(clock, machine);
    this.time = new TickTime(clock, journal, timers, yields, pace);
    this.threads = threads.factory();
    this.meter = new UsageMeter(machine, this.threads::allocatedBytes);
    this.memory = new MemoryWait(this.threads::allocatedBytes);
    this.runnable = new RunQueue(clock, this.threads::processorTime, timers, inbox, journal);
    this.started = new StartedJobs(runnable);
    this.rounds = new Rounds(this, runnable, started);
    this.uncaught = uncaught;
  }

  // ------------------------------------------------------------------ what it has

  /** The time of this tick, in nanoseconds since the kernel was started. */
  public long now() {
    return time.now();
  }

  /** The time of the ticks, and their number. */
  public TickTime time() {
    return time;
  }

  World world() {
    return world;
  }

  public Clock clock() {
    return clock;
  }

  /** The real time, which goes on while simulated time stands still. */
  Clock machine() {
    return machine;
  }

  /** The journal that records all input from outside. */
  public Journal journal() {
    return journal;
  }

  /** The current time, which may be later than that of the tick; for measurements. */
  public long measure() {
    return time.measure();
  }

  /**
   * When a wait ends that begins now and lasts so many nanoseconds. What begins in a tick begins at
   * the same time, but a tick that takes long, because a component is slow, does not use up the
   * wait.
   */
  public long deadline(long wait) {
    return time.deadline(wait);
  }

  public Inbox inbox() {
    return inbox;
  }

  public Timers timers() {
    return timers;
  }

  /** Measures the jobs while somebody looks at them. */
  public Observation observation() {
    return observation;
  }

  /** Measures what the jobs of each lobby use. */
  public UsageMeter meter() {
    return meter;
  }

  /** The budget of code that runs for a lobby. */
  Budget budgetOf(UrbiObject lobby) {
    return lobby instanceof Budgeted owner ? owner.budget() : common;
  }

  /** Takes a timer from the budget of the running job. */
  private Budget admitTimer() {
    if (running == null) {
      return common;
    }
    running.identity().take(Resource.TIMERS);
    return running.budget();
  }

  /** Requests to end code that never lets others run. */
  public Interruptions interruptions() {
    return interruptions;
  }

  /** How the kernel thread waits for memory. */
  public MemoryWait memory() {
    return memory;
  }

  /** Controls how simulated time passes while real activities go on. */
  public SimulationPace pace() {
    return pace;
  }

  /** The scope of code under no tag. */
  public TagScope rootScope() {
    return rootScope;
  }

  /** The stops of tags and of groups. */
  Stops stops() {
    return stops;
  }

  /** The job whose turn it is; null between turns. */
  public @Nullable Job running() {
    return running;
  }

  /** Whether it is the turn of a job with that budget. May be asked on any thread. */
  public boolean isTurnOf(Budget budget) {
    Job job = running;
    return job != null && job.budget() == budget;
  }

  /**
   * The number of this turn: another one whenever a job begins to run, lets others run, or could
   * have. May be asked on any thread.
   */
  public long turn() {
    return turns.getOpaque() + yields.passed();
  }

  /** The running job continues with other work, as if its turn had just begun. */
  public void beginTurn() {
    turns.setOpaque(turns.getPlain() + 1);
  }

  /** All the jobs that have not ended, oldest first. */
  public List<Job> jobs() {
    List<Job> all = new ArrayList<>(jobs.size());
    jobs.addTo(all);
    return all;
  }

  /** Whether a job that has not ended is one of those. */
  public boolean hasJob(Predicate<Job> condition) {
    return jobs.hasAny(condition);
  }

  /** How many jobs have not ended. */
  public int jobCount() {
    return jobs.size();
  }

  /** How many nested calls a job can hold. */
  public int maximumDepth() {
    return threads.maximumDepth();
  }

  JobThread.Factory threads() {
    return threads;
  }

  // ------------------------------------------------------------------ jobs

  /** Starts a job of a group, under the tags of its parent. */
  Job start(Job parent, JobGroup group, Job.Body body) {
    return start(
        new Job(
            this, body, "shell", parent.lobby(), parent.scopeForNew(), group, parent.timeShift()));
  }

  /** Starts a job which nobody waits for. */
  public Job startDetached(UrbiObject lobby, TagScope scope, String prefix, Job.Body body) {
    long shift = running == null ? 0 : running.timeShift();
    return start(new Job(this, body, prefix, lobby, scope, null, shift));
  }

  /** Like {@link #startDetached}, but the job runs first in the next tick. */
  public Job startAhead(UrbiObject lobby, TagScope scope, String prefix, Job.Body body) {
    long shift = running == null ? 0 : running.timeShift();
    Job job = new Job(this, body, prefix, lobby, scope, null, shift);
    started.addAhead(list(job));
    return job;
  }

  /** Like {@link #startDetached}, but the job runs after all others have had their turn. */
  public Job startBehind(UrbiObject lobby, TagScope scope, String prefix, Job.Body body) {
    Job job = new Job(this, body, prefix, lobby, scope, null, 0);
    started.addBehind(list(job));
    return job;
  }

  /** A job started by another one runs in the same tick, right behind it. */
  private Job start(Job job) {
    started.add(list(job), running);
    return job;
  }

  private Job list(Job job) {
    yields.endGrant();
    jobs.add(job.listed);
    observation.started(job, running);
    return job;
  }

  /** A new number, used to name jobs and tags. */
  public long nextNumber() {
    return ++sequence;
  }

  /** Gives a tag its number, if it has none yet: the order in which code has entered tags. */
  void number(TagState tag) {
    if (tag.number() == 0) {
      tag.setNumber(++tagSequence);
    }
  }

  void enqueue(Job job) {
    yields.endGrant();
    enqueueAgain(job);
  }

  /**
   * Queues the running job, which {@linkplain #hasOthers has found} that others wait: it may not go
   * on at once.
   */
  void enqueueAgain(Job job) {
    observation.woken(job, running);
    runnable.add(job);
  }

  void dequeue(Job job) {
    runnable.remove(job);
  }

  void ended(Job job) {
    job.listed.leave();
    observation.ended(job);
  }

  /** Reports an exception that nobody will catch. */
  public void report(@Nullable Job job, Throwable failure) {
    try {
      uncaught.accept(job, failure);
    } catch (OutOfMemoryError e) {
      // There is no memory to say so, but who waits for the end of the job must still learn of it.
      memory.await();
    } catch (LinkageError e) {
      // Without descriptors no file is opened: the classes that tell cannot be loaded.
      FailureLog.internal("what tells of failures", e);
    }
  }

  /** Counts the {@code ;} that let nobody else run. */
  public YieldCount yields() {
    return yields;
  }

  /**
   * Whether a job that could continue should let others run first; to be asked when its {@code ;}
   * does not just {@linkplain YieldCount#passes pass}.
   */
  boolean hasOthers() {
    yields.endGrant();
    if (runnable.isEmpty() && isAlone()) {
      return false;
    }
    yields.reset();
    return true;
  }

  /**
   * Nobody is in the queue: whether the job may go on. It is apart from what each switch does: that
   * is so small that the virtual machine puts it into the loops of compiled code.
   */
  private boolean isAlone() {
    if (!started.isEmpty()
        || ((inbox.isFilled() || counted)
            && journal.yieldsToMessages(yields.count(), inbox.isFilled()))
        || (yields.isOver() && time.isTickDue(!endOfTick.isEmpty()))
        || time.isBusyForLong()) {
      return false;
    }
    yields.grant(running != null && running.needsNoCheckAtYield() ? time.grant() : 0);
    return true;
  }

  /** Whether there are others to run with at least that priority. */
  boolean hasOthersFrom(double priority) {
    return runnable.hasAny(job -> job.priority() >= priority);
  }

  /** The exception for a job that waits where it must not. */
  RuntimeException refusal(Problem problem, Object... places) {
    return refusals.apply(problem, places);
  }

  /** Sets how errors of jobs are made; once, by the interpreter. */
  public void setRefusals(BiFunction<Problem, Object[], RuntimeException> how) {
    refusals = how;
  }

  // ------------------------------------------------------------------ the loop

  /**
   * Starts the kernel thread. Another thread takes its place while it is kept by a job whose stack
   * cannot be put away.
   *
   * @param whenEnded the last action of the loop; called with the failure that ended it, or null
   * @return the thread on which the loop begins
   */
  public Thread startLoop(Consumer<Throwable> whenEnded) {
    return threads.startLoop(() -> runLoop(whenEnded));
  }

  private void runLoop(Consumer<Throwable> whenEnded) {
    loop = Thread.currentThread();
    Throwable wrong = null;
    try {
      loop();
    } catch (LoopMoved moved) {
      return;
    } catch (Throwable failure) {
      wrong = failure;
      report(null, failure);
    }
    whenEnded.accept(wrong);
  }

  /** Whether the loop has ended. */
  boolean isOver() {
    return over;
  }

  /** Whether the calling code runs on the kernel thread, in a job or between jobs. */
  public boolean isKernelThread() {
    // Another thread may read an outdated job here, but never one whose code it runs.
    Job job = running;
    return Thread.currentThread() == loop || (job != null && job.isCurrentThread());
  }

  /** Ends the loop after the turn of the job that is running; on the kernel thread. */
  public void stop() {
    stopped = true;
  }

  /** Whether it is about to end. */
  boolean isStopped() {
    return stopped;
  }

  /**
   * Does something at the end of this tick; on the kernel thread. If there is no memory for it, it
   * is done again at the end of the next tick.
   */
  public void atEndOfTick(Runnable action) {
    endOfTick.add(action);
  }

  private void loop() {
    while (!stopped || rounds.areUnderWay()) {
      try {
        tick();
      } catch (OutOfMemoryError e) {
        rounds.giveUp();
        running = null;
        memory.await();
        report(null, e);
      }
    }
    for (Job job : jobs()) {
      job.terminate();
    }
    // Exceptions end the jobs; code that continues all the same is abandoned.
    for (int round = 0; round < LAST_ROUNDS && !runnable.isEmpty(); round++) {
      rounds.runLast();
    }
    meter.turnOf(null);
    threads.loopEnded();
    runEndOfTick();
    inbox.close();
    over = true;
  }

  private void tick() {
    if (rounds.areUnderWay() || beginTick()) {
      rounds.run();
      runEndOfTick();
      inbox.pollIfDue(time.now());
      time.endTick();
    }
  }

  /** Returns whether there is somebody to run. */
  private boolean beginTick() {
    time.beginTick();
    if (journal.isOver()) {
      stop();
      return false;
    }
    long now = time.now();
    yields.beginTick(now);
    // To read the clock takes a tenth of the time of a short tick.
    boolean delayed = memory.gate().tick(clock.isReal() ? time.read() : machine.now());
    if (inbox.isFilled() || timers.next() <= now || !stops.isEmpty()) {
      delayed = true;
      meter.turnOf(null);
    }
    inbox.take(clock, now);
    if (inbox.isWanting()) {
      memory.await();
    }
    fireTimers();
    stops.goOn();
    started.joinAhead();
    if (runnable.isEmpty() && started.behind() == 0) {
      meter.turnOf(null);
      runEndOfTick();
      time.endEmptyTick();
      if (mayIdle()) {
        time.noteQuiet(inbox);
        if (mayIdle()) {
          time.idle(inbox);
        }
      }
      return false;
    }
    time.countTick();
    // Nobody is to blame for what was done before the jobs.
    rounds.begin(delayed ? clock.now() : time.read());
    return true;
  }

  private boolean mayIdle() {
    return !stopped && endOfTick.isEmpty() && stops.isEmpty();
  }

  /** Runs an action that is not the code of a job: if it fails, the kernel continues. */
  void attempt(Runnable action) {
    try {
      action.run();
    } catch (Throwable failure) {
      report(null, failure);
    }
  }

  /** An exception of one timer must not stop the others. */
  private void fireTimers() {
    boolean failed;
    do {
      failed = false;
      try {
        time.fireTimers();
      } catch (Throwable failure) {
        failed = true;
        report(null, failure);
      }
    } while (failed);
  }

  /** Nobody's turn begins. */
  void endTurn() {
    running = null;
    observation.turnOf(null);
  }

  /**
   * At no time the turn seems to be that of another job, which other threads would blame for it.
   */
  void beginTurnOf(Job job) {
    running = null;
    VarHandle.storeStoreFence();
    beginTurn();
    VarHandle.storeStoreFence();
    running = job;
    interruptions.beginTurnOf(job);
    meter.turnOf(job.budget());
    observation.turnOf(job);
  }

  private void runEndOfTick() {
    if (!endOfTick.isEmpty()) {
      meter.turnOf(null);
    }
    endOfTick.run(failure -> report(null, failure));
    if (!endOfTick.isEmpty()) {
      memory.await();
    }
  }
}
