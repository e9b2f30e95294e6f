package org.urbi.kernel.node;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobObserver;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.object.UrbiObject;

/** Counts and times the calls that a piece of code makes (manual, "Profile"). */
public final class Profiler {
  /** The calls of one function; times are in nanoseconds. */
  public static final class Calls {
    private final String name;
    private long count;
    private long self;

    private Calls(String name) {
      this.name = name;
    }

    public String name() {
      return name;
    }

    public long count() {
      return count;
    }

    /** The time spent in the function itself. */
    public long self() {
      return self;
    }
  }

  private final Interpreter interpreter;
  private final Scheduler clock;
  private final Map<Object, Calls> calls = new IdentityHashMap<>();
  private final List<Calls> order = new ArrayList<>();
  private final long begin;
  private long wallClock;
  private long yields;
  private int maximumDepth;

  public Profiler(Interpreter interpreter) {
    this.interpreter = interpreter;
    this.clock = interpreter.scheduler();
    this.begin = clock.measure();
  }

  /** Begins to observe a job, and the jobs that it starts. */
  public void observe(Job job) {
    interpreter.startProfiling();
    job.observe(new Stack());
  }

  /** Ends the profiling of the code in that job; jobs that it has started are still observed. */
  public void finished(Job job) {
    wallClock = clock.measure() - begin;
    job.observe(null);
  }

  /** The functions called, in the order of their first calls. */
  public List<Calls> calls() {
    return List.copyOf(order);
  }

  public int maximumDepth() {
    return maximumDepth;
  }

  /** How often an observed job has let others run. */
  public long yields() {
    return yields;
  }

  /** The time from the beginning of the code to its end, in nanoseconds. */
  public long wallClock() {
    return wallClock;
  }

  /** Called at the beginning of each call, while there is a profiler. */
  public static @Nullable Stack enter(Job job, String name, Object key) {
    if (job.observer() instanceof Stack stack) {
      stack.enter(name, key);
      return stack;
    }
    return null;
  }

  /**
   * Wraps code of a job that is executed later, perhaps by another job, so that it still counts for
   * the profiler of this job.
   *
   * @param name the name under which executions of the code are counted
   * @return the code itself, when nobody observes the job
   */
  public static Node observing(Job job, String name, Node code) {
    return job.observer() instanceof Stack stack ? stack.profiler().new Observed(name, code) : code;
  }

  /** Code that counts for this profiler in whatever job it is executed. */
  private final class Observed extends Node {
    private final String name;
    private final Node code;

    Observed(String name, Node code) {
      super(code.span());
      this.name = name;
      this.code = code;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      Job job = frame.job;
      JobObserver before = job.observer();
      Stack stack =
          before instanceof Stack going && going.profiler() == Profiler.this ? going : new Stack();
      job.observe(stack);
      stack.enter(name, code);
      try {
        return code.execute(frame);
      } finally {
        stack.leave();
        job.observe(before);
      }
    }
  }

  /** The calls in progress in one job. */
  public final class Stack implements JobObserver {
    private final ArrayDeque<Calls> going = new ArrayDeque<>();
    private long since = clock.measure();

    private Profiler profiler() {
      return Profiler.this;
    }

    private void enter(String name, Object key) {
      account();
      Calls entered = calls.get(key);
      if (entered == null) {
        entered = new Calls(calls.isEmpty() ? "<profiled>" : name);
        calls.put(key, entered);
        order.add(entered);
      }
      entered.count++;
      going.push(entered);
      maximumDepth = Math.max(maximumDepth, going.size());
    }

    /** The innermost call has ended. */
    public void leave() {
      account();
      going.poll();
    }

    private void account() {
      long now = clock.measure();
      if (!going.isEmpty()) {
        going.peek().self += now - since;
      }
      since = now;
    }

    @Override
    public void switchedOut() {
      account();
      yields++;
    }

    @Override
    public void switchedIn() {
      since = clock.measure();
    }

    @Override
    public JobObserver forChild() {
      return new Stack();
    }
  }
}
