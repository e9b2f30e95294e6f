package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Budgeted;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** A tick loop whose jobs are Java code. It ends when there is nothing left to do. */
final class Loop {
  static final long SECOND = 1_000_000_000;

  final World world = new World();
  final ManualClock clock;

  /** Goes on, if at all, while a simulated time stands still. */
  final ManualClock machine = ManualClock.real();

  final Scheduler scheduler;

  /** What nobody has caught. */
  final List<Throwable> uncaught = new ArrayList<>();

  /** What the jobs say. */
  final List<String> said = new ArrayList<>();

  /** In simulated time. */
  Loop() {
    this(JobThreads.AUTO);
  }

  Loop(JobThreads threads) {
    this(ManualClock.simulated(), Journal.NONE, threads);
  }

  Loop(ManualClock clock) {
    this(clock, Journal.NONE, JobThreads.AUTO);
  }

  Loop(Journal journal) {
    this(ManualClock.simulated(), journal, JobThreads.AUTO);
  }

  /** What nobody has caught is told to somebody else. */
  Loop(BiConsumer<Job, Throwable> told) {
    this(ManualClock.simulated(), Journal.NONE, JobThreads.AUTO, told);
  }

  private Loop(ManualClock clock, Journal journal, JobThreads threads) {
    this(clock, journal, threads, null);
  }

  private Loop(
      ManualClock clock,
      Journal journal,
      JobThreads threads,
      @Nullable BiConsumer<Job, Throwable> told) {
    this.clock = clock;
    scheduler =
        new Scheduler(
            world,
            clock,
            machine,
            journal,
            threads,
            told == null ? (job, failure) -> uncaught.add(failure) : told);
    scheduler.time().whenQuiet(scheduler::stop);
  }

  /** A message that has something done by the next tick. */
  void post(Runnable task) {
    Inbox inbox = scheduler.inbox();
    int number = inbox.reserve();
    inbox.register(
        number,
        message -> {
          inbox.forget(number);
          task.run();
        });
    inbox.post(new Message.InputEnded(number));
  }

  void say(String what) {
    said.add(what);
  }

  /** An object that can be a lobby, a value, or whatever. */
  UrbiObject object() {
    return world.values().object.cloned();
  }

  /** A lobby with a budget of its own. */
  UrbiObject lobby() {
    return new Lobby(world.values().object.cloneShape());
  }

  private static final class Lobby extends UrbiObject implements Budgeted {
    private final Budget budget = new Budget();

    Lobby(Shape shape) {
      super(shape);
    }

    @Override
    public Budget budget() {
      return budget;
    }
  }

  /** A job under no tag, for no lobby. */
  Job start(Job.Body body) {
    return start(scheduler.rootScope(), body);
  }

  Job start(TagScope scope, Job.Body body) {
    return scheduler.startDetached(null, scope, "job", body);
  }

  /** A job that is not to run. */
  Job idle(UrbiObject lobby) {
    return new Job(scheduler, job -> {}, "job", lobby, scheduler.rootScope(), null, 0);
  }

  /** Every job under a scope, in the order in which they came. */
  static List<Job> jobsUnder(TagScope scope) {
    List<Job> jobs = new ArrayList<>();
    scope.collect(jobs);
    return jobs;
  }

  /** Runs until nothing is left; returns what the jobs have said. */
  List<String> run() {
    try {
      scheduler.startLoop(failure -> {}).join();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
    assertEquals(List.of(), uncaught);
    return said;
  }
}
