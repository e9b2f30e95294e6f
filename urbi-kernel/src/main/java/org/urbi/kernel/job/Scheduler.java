package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.lang.invoke.VarHandle;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Budgeted;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;
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
  /** Simulated time moves on after jobs have been runnable in this many cycles in a row… */
  private static final int BUSY_CYCLES = 1000;

  /**
   * …by a microsecond for each: otherwise a job that never waits would keep sleeping jobs asleep
   * for ever.
   */
  private static final long BUSY_STEP = 1000L * BUSY_CYCLES;

  /** The limit of jobs that start and run in one tick: they must not starve the others. */
  private static final int BIRTHS_PER_TICK = 100_000;

  /** The same for those started by jobs of that tick, which may be an endless chain. */
  private static final int DESCENDANTS_PER_TICK = 1000;

  /** From when on a tick has taken long, in nanoseconds. */
  private static final long LONG_TICK = 10_000_000;

  /** How many turns the jobs get for ending when the kernel ends. */
  private static final int LAST_ROUNDS = 1000;

  private final World world;
  private final Clock clock;
  private final Clock machine;
  private volatile @Nullable Thread loop;
  private final Inbox inbox;
  private final Journal journal;
  private final boolean counted;
  private final Timers timers = new Timers(this::admitTimer);
  private final Budget common = new Budget();
  private final UsageMeter meter;
  private @Nullable TurnMeter turnMeter;
  private int observers;
  private final SimulationPace pace;
  private Runnable whenQuiet = () -> {};
  private Runnable memoryRelief = () -> {};
  private final Interruptions interruptions;
  private final JobThread.Factory threads;
  private final RunQueue runnable;
  private final JobList ahead = new JobList();
  private final JobList behind = new JobList();
  private final JobList born = new JobList();
  private final JobList jobs = new JobList();
  private final TagScope rootScope = new TagScope();
  private final EndOfTick endOfTick = new EndOfTick();
  private final BiConsumer<Job, Throwable> uncaught;
  private BiFunction<Problem, Object[], RuntimeException> refusals =
      (problem, places) -> new IllegalStateException(problem.text(places));
  private final AtomicLong turns = new AtomicLong();
  private int births;
  private int descendants;
  private final YieldCount yields = new YieldCount();
  private long busyUntil = 1 + BUSY_CYCLES;
  private long now;
  private long cycle;
  private int timeHolders;
  private @Nullable Job running;
  private boolean stopped;
  private volatile boolean over;
  private long sequence;
  private long tagSequence;
  private final CycleStatistics statistics = new CycleStatistics();

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
    this.journal = journal;
    this.counted = journal.countsChecks();
    this.inbox = new Inbox(journal);
    this.interruptions = new Interruptions(this::turn, journal, machine);
    this.clock = clock;
    this.pace = new SimulationPace(clock, machine);
    this.meter = new UsageMeter(machine);
    this.threads = threads.factory(inbox);
    this.runnable = new RunQueue(clock, this.threads::processorTime, timers, inbox, journal);
    this.uncaught = uncaught;
    inbox.register(Message.JOBS, this.threads::take);
  }

  // ------------------------------------------------------------------ what it has

  /** The time of this tick, in nanoseconds since the kernel was started. */
  public long now() {
    return now;
  }

  World world() {
    return world;
  }

  public Clock clock() {
    return clock;
  }

  /** The journal that records all input from outside. */
  public Journal journal() {
    return journal;
  }

  /** The current time, which may be later than that of the tick; for measurements. */
  public long measure() {
    if (!counted) {
      return clock.now();
    }
    return query(clock::now);
  }

  /**
   * When a wait ends that begins now and lasts so many nanoseconds. What begins in a tick begins at
   * the same time, but a tick that takes long, because a component is slow, does not use up the
   * wait.
   */
  public long deadline(long wait) {
    long time = clock.isReal() ? measure() : now;
    return (time - now < LONG_TICK ? now : time) + wait;
  }

  private <T> T query(Outcome.Work<T> work) {
    try {
      return requireNonNull(journal.query(work), "what is looked at is there");
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * The number of ticks so far, including those that were skipped because only one job could run.
   */
  public long cycle() {
    return cycle + yields.passed();
  }

  public Inbox inbox() {
    return inbox;
  }

  public Timers timers() {
    return timers;
  }

  /** How long ticks take. */
  public CycleStatistics statistics() {
    return statistics;
  }

  /** From now on somebody looks at the jobs: the {@linkplain Job#ran turns} are measured. */
  public void beginObservation() {
    if (observers++ == 0) {
      turnMeter = new TurnMeter(machine);
    }
  }

  /** Ends one {@link #beginObservation}. */
  public void endObservation() {
    if (--observers == 0) {
      turnMeter = null;
    }
  }

  /**
   * The turns of the traced jobs that have been kept.
   *
   * @param from the number of the first one that is wanted
   */
  public List<Turn> turns(long from) {
    return turnMeter == null ? List.of() : turnMeter.turns(from);
  }

  /** The number that the next turn of a traced job gets. */
  public long nextTurn() {
    return turnMeter == null ? 0 : turnMeter.next();
  }

  /** The time of the machine, for measurements that the run does not depend on; nanoseconds. */
  public long machineTime() {
    return machine.now();
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
    running.take(Resource.TIMERS);
    return running.budget();
  }

  /** Requests to end code that never lets others run. */
  public Interruptions interruptions() {
    return interruptions;
  }

  /**
   * Tries to start an activity outside, and returns whether it could. In a replay nothing is
   * started, and the recorded result is returned.
   */
  public boolean attempt(BooleanSupplier beginning) {
    return query(beginning::getAsBoolean);
  }

  /**
   * Sets an action that runs whenever the kernel is quiet: there is nothing to run, no deadline,
   * and no activity outside that the kernel has started, so that only a message could bring more.
   * To be called before the start.
   */
  public void whenQuiet(Runnable action) {
    whenQuiet = action;
  }

  /**
   * Sets what waits until somebody has been asked to give back memory. To be called before the
   * start.
   */
  public void setMemoryRelief(Runnable how) {
    memoryRelief = how;
  }

  /** There was no memory for something: the kernel waits until somebody has been asked for some. */
  public void awaitMemory() {
    try {
      KernelThreadPin.pin();
      try {
        memoryRelief.run();
      } finally {
        KernelThreadPin.unpin();
      }
    } catch (OutOfMemoryError e) {
      // There is none for waiting, either: whoever has caught the first one goes on.
      return;
    }
  }

  /** The code of the running job has failed; whatever it does next is a new turn. */
  public void recover(Throwable failure) {
    if (failure instanceof OutOfMemoryError) {
      awaitMemory();
    }
    beginTurn();
  }

  /** Controls how simulated time passes while real activities go on. */
  public SimulationPace pace() {
    return pace;
  }

  /** The scope of code under no tag. */
  public TagScope rootScope() {
    return rootScope;
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

  /** How many nested calls a job can hold. */
  public int maximumDepth() {
    return threads.maximumDepth();
  }

  JobThread newThread(Job job) {
    return threads.create(job);
  }

  // ------------------------------------------------------------------ jobs

  /** Starts a job of a group, under the tags of its parent. */
  Job start(Job parent, JobGroup group, Job.Body body) {
    return start(
        new Job(this, body, "shell", parent.lobby(), parent.scope(), group, parent.timeShift()));
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
    yields.endGrant();
    jobs.add(job.listed);
    ahead.add(job.turn);
    return job;
  }

  /** Like {@link #startDetached}, but the job runs after all others have had their turn. */
  public Job startBehind(UrbiObject lobby, TagScope scope, String prefix, Job.Body body) {
    Job job = new Job(this, body, prefix, lobby, scope, null, 0);
    yields.endGrant();
    jobs.add(job.listed);
    behind.add(job.turn);
    return job;
  }

  /** A job started by another one runs in the same tick, right behind it. */
  private Job start(Job job) {
    yields.endGrant();
    jobs.add(job.listed);
    if (running == null || births >= BIRTHS_PER_TICK || descendants >= DESCENDANTS_PER_TICK) {
      runnable.add(job);
    } else {
      births++;
      if (runnable.isFresh()) {
        descendants++;
      }
      born.add(job.turn);
    }
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
    if (turnMeter != null) {
      Job waker = running;
      job.wokenBy(waker == null ? 0 : waker.number());
    }
    runnable.add(job);
  }

  void dequeue(Job job) {
    runnable.remove(job);
  }

  void ended(Job job) {
    job.listed.leave();
  }

  /** Reports an exception that nobody will catch. */
  public void report(@Nullable Job job, Throwable failure) {
    try {
      uncaught.accept(job, failure);
    } catch (OutOfMemoryError e) {
      // There is no memory to say so, but who waits for the end of the job must still learn of it.
      awaitMemory();
    }
  }

  /** Whether a job that could continue should let others run first. */
  boolean hasOthers() {
    return (inbox.isFilled() || !yields.passes()) && looksForOthers();
  }

  private boolean looksForOthers() {
    yields.endGrant();
    if (!runnable.isEmpty()
        || !born.isEmpty()
        || !ahead.isEmpty()
        || !behind.isEmpty()
        || ((inbox.isFilled() || counted)
            && journal.yieldsToMessages(yields.count(), inbox.isFilled()))
        || (yields.isOver() && isTickDue())
        || isBusyForLong()) {
      yields.reset();
      return true;
    }
    yields.grant(counted ? 0 : clock.isReal() ? Long.MAX_VALUE : busyUntil - cycle() - 1);
    return false;
  }

  /** Nobody can run, but timers may be due. Only where nobody counts, a tick may be left out. */
  private boolean isTickDue() {
    if (counted || !clock.isReal()) {
      return true;
    }
    long time = clock.now();
    boolean due = yields.look(time) || time >= timers.next() || !endOfTick.isEmpty();
    yields.reset();
    now = Math.max(now, time);
    return due;
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
   * Starts the kernel thread.
   *
   * @param whenEnded its last action; called with the failure that ended the loop, or null
   */
  public Thread startLoop(Consumer<Throwable> whenEnded) {
    return threads.startLoop(() -> {
      loop = Thread.currentThread();
      Throwable wrong = null;
      try {
        loop();
      } catch (Throwable failure) {
        wrong = failure;
        report(null, failure);
      } finally {
        whenEnded.accept(wrong);
      }
    });
  }

  /**
   * Ends jobs that hold the kernel for longer without letting others run; once, when the kernel has
   * been started.
   *
   * @param limit in nanoseconds; {@link Long#MAX_VALUE} for none
   * @param freeMemory how many bytes of memory are free
   * @param told called on another thread when that has happened
   */
  public HoldWatchdog limitHolding(
      long limit, LongSupplier freeMemory, HoldWatchdog.Listener told) {
    HoldWatchdog watch =
        new HoldWatchdog(
            this,
            machine,
            new HoldWatchdog.Gauges(threads::processorTime, threads::allocatedBytes, freeMemory),
            limit,
            told);
    watch.start();
    return watch;
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

  /**
   * Does something at the end of this tick; on the kernel thread. If there is no memory for it, it
   * is done again at the end of the next tick.
   */
  public void atEndOfTick(Runnable action) {
    endOfTick.add(action);
  }

  /** Holds simulated time, because more input is expected for the present moment. */
  public void holdTime() {
    timeHolders++;
  }

  public void releaseTime() {
    timeHolders--;
  }

  private void loop() {
    while (!stopped) {
      try {
        tick();
      } catch (OutOfMemoryError e) {
        running = null;
        awaitMemory();
        report(null, e);
      }
    }
    for (Job job : jobs()) {
      job.terminate();
    }
    // Exceptions end the jobs; code that continues all the same is abandoned.
    for (int rounds = 0; rounds < LAST_ROUNDS && !runnable.isEmpty(); rounds++) {
      runOnce(true);
    }
    meter.turnOf(null);
    threads.loopEnded();
    runEndOfTick();
    inbox.close();
    over = true;
  }

  private void tick() {
    // Input that was awaited while time was held could as well have arrived in the cycle before, so
    // it does not start a new count.
    boolean begins = clock.isReal() || timeHolders == 0;
    if (begins) {
      cycle++;
    }
    long before = now;
    now = Math.max(now, journal.tick(Math.max(now, clock.now())));
    if (journal.isOver()) {
      stop();
      return;
    }
    yields.beginTick(now);
    if (inbox.isFilled() || timers.next() <= now) {
      meter.turnOf(null);
    }
    inbox.take(clock, now);
    if (inbox.isWanting()) {
      awaitMemory();
    }
    fireTimers();
    for (Job job = ahead.poll(); job != null; job = ahead.poll()) {
      runnable.addFirst(job);
    }
    if (runnable.isEmpty() && behind.isEmpty()) {
      meter.turnOf(null);
      runEndOfTick();
      if (begins && !clock.isReal() && timers.next() == Long.MAX_VALUE) {
        cycle--;
      } else if (begins) {
        statistics.add(now - before);
      }
      // Counted from the cycle that may find something first.
      busyUntil = cycle() + (timeHolders == 0 ? 1 : 0) + BUSY_CYCLES;
      if (!stopped && endOfTick.isEmpty()) {
        if (timers.next() == Long.MAX_VALUE && !inbox.isFilled() && !pace.isReal()) {
          whenQuiet.run();
        }
        if (!stopped && endOfTick.isEmpty()) {
          idle();
        }
      }
      return;
    }
    if (begins) {
      statistics.add(now - before);
    }
    runOnce(false);
    runBehind();
    runEndOfTick();
    inbox.pollIfDue(now);
    if (timeHolders > 0) {
      busyUntil = cycle() + BUSY_CYCLES;
    } else if (isBusyForLong()) {
      busyUntil = cycle() + BUSY_CYCLES;
      clock.advanceTo(now + BUSY_STEP);
    }
  }

  /** Whether simulated time must move on although jobs have been runnable all the time. */
  private boolean isBusyForLong() {
    return cycle() >= busyUntil && !clock.isReal();
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
        timers.fire(now);
      } catch (Throwable failure) {
        failed = true;
        report(null, failure);
      }
    } while (failed);
  }

  private void runOnce(boolean last) {
    births = 0;
    descendants = 0;
    runnable.beginRound(last);
    Job job;
    while ((last || !stopped) && (job = runnable.next()) != null) {
      beginTurnOf(job);
      job.resume();
      for (Job child = born.pollLast(); child != null; child = born.pollLast()) {
        runnable.addToRound(child);
      }
    }
    running = null;
    beginTurn();
    endTurn();
  }

  private void endTurn() {
    if (turnMeter != null) {
      turnMeter.turnOf(null);
    }
  }

  /**
   * At no time the turn seems to be that of another job, which other threads would blame for it.
   */
  private void beginTurnOf(Job job) {
    running = null;
    VarHandle.storeStoreFence();
    beginTurn();
    VarHandle.storeStoreFence();
    running = job;
    interruptions.beginTurnOf(job);
    meter.turnOf(job.budget());
    if (turnMeter != null) {
      turnMeter.turnOf(job);
    }
  }

  private void runBehind() {
    Job job;
    for (int left = behind.size(); left > 0 && !stopped && (job = behind.poll()) != null; left--) {
      beginTurnOf(job);
      job.resume();
      for (Job child = born.poll(); child != null; child = born.poll()) {
        runnable.add(child);
      }
    }
    running = null;
    endTurn();
  }

  private void runEndOfTick() {
    if (!endOfTick.isEmpty()) {
      meter.turnOf(null);
    }
    endOfTick.run(failure -> report(null, failure));
    if (!endOfTick.isEmpty()) {
      awaitMemory();
    }
  }

  private void idle() {
    if (journal.isReplay()) {
      return;
    }
    journal.idle();
    long next = timers.next();
    if (clock.isReal()) {
      inbox.listen(next == Long.MAX_VALUE ? Long.MAX_VALUE : next - clock.now());
    } else if (timeHolders > 0) {
      inbox.await(Long.MAX_VALUE);
    } else if (pace.isReal()) {
      pace.idle(inbox, next);
    } else if (next == Long.MAX_VALUE) {
      inbox.await(Long.MAX_VALUE);
    } else if (!inbox.isFilled()) {
      clock.advanceTo(next);
    }
  }
}
