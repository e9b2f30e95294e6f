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

  private record Task(Runnable action, int size) {}

  private final Scheduler scheduler;
  private final Supplier<? extends UrbiObject> lobby;
  private final IntConsumer consumed;
  private final Consumer<RuntimeException> failed;
  private final ArrayDeque<Task> tasks = new ArrayDeque<>();
  private long added;

  /** The number of the last task to execute without letting others run. */
  private long urgent;

  private @Nullable Job job;
  private boolean waiting;
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

  /** Executes all tasks added so far before other jobs have their turn. */
  void finishFirst() {
    urgent = added;
  }

  private void run(Job self) {
    long done = 0;
    while (!ended) {
      Task task = tasks.poll();
      if (task == null) {
        waiting = true;
        self.waitForWake();
        continue;
      }
      perform(task.action);
      if (task.size > 0) {
        consumed.accept(task.size);
      }
      if (++done % TURN == 0 && done >= urgent) {
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
  }
}
