package org.urbi.kernel.remote;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.Unwinding;
import org.urbi.kernel.object.UrbiObject;

/** What a remote process has asked for, and the job that does it, one after the other. */
final class RemoteTasks {
  /** How many are done before others have their turn. */
  private static final int TURN = 256;

  private record Task(Runnable action, int size) {}

  private final Scheduler scheduler;
  private final Supplier<? extends UrbiObject> lobby;
  private final IntConsumer consumed;
  private final Consumer<RuntimeException> failed;
  private final Queue<Task> tasks = new ConcurrentLinkedQueue<>();
  private final AtomicBoolean announced = new AtomicBoolean();
  private final AtomicLong added = new AtomicLong();

  /** Up to this one, tasks are done without a break. */
  private volatile long urgent;

  private Job job;
  private boolean waiting;
  private volatile boolean ended;

  /**
   * @param consumed is told how many bytes of input have been done
   * @param failed is told what a task has thrown
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

  /** Adds a task, for which {@link #start} is to be called; from any thread. */
  void add(Runnable action, int size) {
    if (!ended) {
      tasks.add(new Task(action, size));
      added.incrementAndGet();
    }
  }

  /** Has all that has been added done before others have their turn; from any thread. */
  void startAll() {
    urgent = added.get();
    start();
  }

  /** Has the tasks done; from any thread. */
  void start() {
    if (!tasks.isEmpty() && announced.compareAndSet(false, true)) {
      scheduler.inbox().post(this::wake);
    }
  }

  private void wake() {
    if (job == null) {
      UrbiObject own = lobby.get();
      job = scheduler.startDetached(own, scheduler.rootScope(), "remote", this::run);
    } else if (waiting) {
      waiting = false;
      job.wake();
    }
  }

  private void run(Job self) {
    long done = 0;
    while (!ended) {
      Task task = tasks.poll();
      if (task == null) {
        announced.set(false);
        task = tasks.poll();
        if (task == null) {
          waiting = true;
          self.waitForWake();
          continue;
        }
        announced.set(true);
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
    } catch (Unwinding e) {
      throw e;
    } catch (RuntimeException e) {
      failed.accept(e);
    }
  }

  /** Whether the job that is running is the one that does the tasks. */
  boolean areRunning() {
    return job != null && scheduler.running() == job;
  }

  /** There is nothing more to be done. */
  void end() {
    ended = true;
  }
}
