package org.urbi.kernel.remote;

import java.util.ArrayDeque;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.object.UrbiObject;

/**
 * The requests of a remote process, and the job that executes them one after the other. Used on the
 * kernel thread.
 */
final class RemoteTasks {
  /** How many tasks are executed before other jobs have their turn. */
  private static final int TURN = 256;

  /** After how long it is looked again whether a task waits, in nanoseconds. */
  private static final long PATIENCE = 1_000_000;

  private record Task(Runnable action, int size) {}

  /** An answer, and the number of the last task that has come before it. */
  private record Answer(long last, Runnable action) {}

  private final Scheduler scheduler;
  private final Supplier<? extends UrbiObject> lobby;
  private final IntConsumer consumed;
  private final Consumer<RuntimeException> failed;
  private final ArrayDeque<Task> tasks = new ArrayDeque<>();
  private final ArrayDeque<Answer> answers = new ArrayDeque<>();
  private long added;
  private long done;

  private @Nullable Job job;
  private boolean waiting;
  private boolean performing;
  private boolean looking;
  private boolean ended;

  /**
   * @param consumed called with the number of input bytes that a task has consumed
   * @param failed called with what a task has thrown
   */
  RemoteTasks(
      Scheduler scheduler,
      Supplier<? extends UrbiObject> lobby,
      IntConsumer consumed,
      Consumer<RuntimeException> failed) {
    this.scheduler = scheduler;
    this.lobby = lobby;
    this.consumed = consumed;
    this.failed = failed;
  }

  /** Adds a task. */
  void add(Runnable action, int size) {
    if (ended) {
      return;
    }
    tasks.add(new Task(action, size));
    added++;
    if (job == null) {
      UrbiObject own = lobby.get();
      job = scheduler.startDetached(own, scheduler.rootScope(), "remote", this::run);
    } else if (waiting) {
      waiting = false;
      job.wake();
    }
  }

  /**
   * Gives an answer once all tasks added so far are executed. If one of them waits, perhaps for
   * that very answer, it is given before.
   */
  void whenFinished(Runnable answer) {
    if (ended || done == added) {
      answer.run();
      return;
    }
    answers.add(new Answer(added, answer));
    if (!looking) {
      scheduler.atEndOfTick(this::look);
      looking = true;
    }
  }

  private void look() {
    looking = false;
    if (performing) {
      answer(Long.MAX_VALUE);
    } else if (!answers.isEmpty()) {
      // The tasks have not had their turn yet.
      scheduler.timers().add(scheduler.now() + PATIENCE, this::look);
      looking = true;
    }
  }

  private void answer(long finished) {
    while (!answers.isEmpty() && answers.getFirst().last <= finished) {
      answers.poll().action.run();
    }
  }

  private void run(Job self) {
    while (!ended) {
      Task task = tasks.poll();
      if (task == null) {
        waiting = true;
        self.waitForWake();
        continue;
      }
      performing = true;
      perform(task.action);
      performing = false;
      if (task.size > 0) {
        consumed.accept(task.size);
      }
      done++;
      answer(done);
      if (done % TURN == 0 && answers.isEmpty()) {
        self.yield();
      }
    }
  }

  private void perform(Runnable action) {
    try {
      action.run();
    } catch (ControlFlowException e) {
      throw e;
    } catch (RuntimeException e) {
      failed.accept(e);
    } catch (Throwable e) {
      FailureLog.internal("a task of a remote process", e);
      failed.accept(new IllegalStateException(FailureLog.text(e), e));
    }
  }

  /** Whether the running job is the one that executes the tasks. */
  boolean areRunning() {
    return job != null && scheduler.running() == job;
  }

  /** Ends the job: no more tasks will come. */
  void end() {
    ended = true;
    answer(Long.MAX_VALUE);
  }
}
