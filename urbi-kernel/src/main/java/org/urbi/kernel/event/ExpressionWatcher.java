package org.urbi.kernel.event;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobOwner;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/**
 * Evaluates an expression again each time something changes that its last evaluation has read: a
 * slot, a variable, the content of a container. It never polls.
 */
final class ExpressionWatcher implements Dependencies.Watcher {
  /** Receives each new value. */
  interface Listener {
    /**
     * The expression has a new value.
     *
     * @param evaluator the job which caused the change and in which it was evaluated
     */
    void evaluated(UrbiObject value, Job evaluator);
  }

  private final Frame home;
  private final Node expression;
  private final UrbiObject lobby;
  private final Listener listener;
  private final WatchedSources sources = new WatchedSources(this);
  private @Nullable Job evaluator;
  private boolean again;
  private boolean apart;
  private boolean closed;

  ExpressionWatcher(Frame home, Node expression, Listener listener) {
    this.home = home;
    this.expression = expression;
    this.lobby = home.job().lobby();
    this.listener = listener;
  }

  /**
   * Evaluates the expression for the first time and begins to watch what it reads. An evaluation
   * can take time; if another job changes what it has read meanwhile, it is done again.
   */
  void begin(Job job) {
    listener.evaluated(evaluate(job), job);
    if (again) {
      evaluateAgain(job);
    }
  }

  /** Begins; if that fails, or is ended, what has been done for it until then is undone. */
  void begin(Job job, Runnable undo) {
    boolean begun = false;
    try {
      begin(job);
      begun = true;
    } finally {
      if (!begun) {
        undo.run();
      }
    }
  }

  private UrbiObject evaluate(Job job) {
    World world = home.interpreter().world();
    Dependencies.Tracker outer = world.tracker;
    sources.begin();
    world.tracker = sources;
    evaluator = job;
    try {
      return job.identity().doFor(lobby, () -> expression.execute(home.in(job)));
    } finally {
      evaluator = null;
      world.tracker = outer;
      if (closed) {
        sources.close();
      } else {
        sources.end();
      }
    }
  }

  @Override
  public void invalidated() {
    if (closed) {
      return;
    }
    Scheduler scheduler = home.job().scheduler();
    Job running = scheduler.running();
    if (evaluator != null) {
      // If another job changes what a running evaluation reads, evaluate once more afterwards.
      // Changes made by the evaluation itself do not count.
      again |= running != evaluator;
      return;
    }
    if (running == null) {
      startEvaluation(scheduler);
    } else if (running.identity().isAbove(lobby)) {
      setApart(scheduler);
    } else {
      evaluateAgain(running);
    }
  }

  /** Who may do more neither waits for the condition nor is ended with it; changes add up. */
  private void setApart(Scheduler scheduler) {
    if (!apart) {
      apart = true;
      JobOwner.start(
              scheduler,
              lobby,
              "watch",
              job -> {
                apart = false;
                evaluateAgain(job);
              })
          .onEnd(() -> apart = false);
    }
  }

  /** Conditions of the lobby whose code must end are given up with it. */
  @Override
  public void invalidatedLater() {
    Scheduler scheduler = home.job().scheduler();
    Job running = scheduler.running();
    if (closed || running != null && running.lobby() == lobby) {
      return;
    }
    if (evaluator != null) {
      again = true;
    } else {
      startEvaluation(scheduler);
    }
  }

  private void startEvaluation(Scheduler scheduler) {
    JobOwner.start(scheduler, lobby, "watch", this::evaluateAgain);
  }

  private void evaluateAgain(Job job) {
    // There may be very many conditions, which call nothing that would look.
    job.checkInterrupted();
    // A condition whose evaluation keeps changing its own value must not loop for ever.
    for (int rounds = 0; rounds < 100 && !closed; rounds++) {
      again = false;
      UrbiObject value;
      World world = home.interpreter().world();
      Dependencies.Tracker outer = world.tracker;
      world.tracker = null;
      try {
        value = evaluate(job);
        if (!closed) {
          listener.evaluated(value, job);
        }
      } catch (UrbiException e) {
        // A job that must end does not go on with the next condition.
        home.interpreter().report(home.job(), e.unlessUncatchable());
      } finally {
        world.tracker = outer;
      }
      if (!again) {
        return;
      }
    }
  }

  @Override
  public String description() {
    return expression.span().text();
  }

  /** The names of what the last evaluation has read. */
  List<String> read(int most) {
    return sources.names(most);
  }

  /** Watches no more. */
  void close() {
    closed = true;
    if (evaluator == null) {
      sources.close();
    }
  }
}
