package org.urbi.kernel.uobject;

import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.ComponentCode;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.log.Defects;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import urbi.spi.ContextEndedException;

/**
 * Requests of other threads to the kernel thread: each is executed by a job, and the thread waits.
 */
final class KernelRequests {
  /**
   * @param slot the variable that the message names, if any
   * @param task what only the thread knows; null if the message says it
   */
  private record Request<T>(
      @Nullable PluggedSlot slot, @Nullable Function<Frame, T> task, CompletableFuture<T> future) {
    /** Executes it; in a job. */
    // The thread asks for what the task of its message returns.
    @SuppressWarnings("unchecked")
    void perform(Frame frame, ComponentTasks tasks, Message.OfComponent asked) {
      try {
        future.complete(
            KernelCrossing.translated(
                frame, of -> task == null ? (T) tasks.run(of, asked, slot) : task.apply(of)));
      } catch (ControlFlowException e) {
        future.completeExceptionally(stopped());
        throw e;
      } catch (RuntimeException | Error e) {
        Defects.log("a request of a component", e);
        future.completeExceptionally(e);
      }
    }
  }

  private final Interpreter interpreter;
  private final Inbox inbox;
  private final ComponentTasks tasks;
  private final AtomicInteger last = new AtomicInteger();
  private final Map<Integer, Request<?>> pending = new ConcurrentHashMap<>();
  private final ThreadLocal<KernelLock> held = new ThreadLocal<>();
  private volatile boolean over;

  KernelRequests(Interpreter interpreter, ComponentTasks tasks) {
    this.interpreter = interpreter;
    this.inbox = interpreter.scheduler().inbox();
    this.tasks = tasks;
  }

  /**
   * Has a task executed by a job that only this thread knows, and waits.
   *
   * @throws IllegalStateException if the kernel has ended
   * @throws CancellationException if the thread is interrupted; the task is executed all the same
   */
  <T> @Nullable T ask(Function<Frame, T> task) {
    return ask(Message.ComponentRequest::new, new Request<>(null, task, new CompletableFuture<>()));
  }

  /**
   * Has a job do what a message says, and waits.
   *
   * @param what makes the message with that number
   * @param slot the variable that it names, if any
   * @throws IllegalStateException if the kernel has ended
   * @throws CancellationException if the thread is interrupted; it is done all the same
   */
  <T> @Nullable T ask(IntFunction<? extends Message.OfComponent> what, @Nullable PluggedSlot slot) {
    return ask(what, new Request<T>(slot, null, new CompletableFuture<>()));
  }

  private <T> @Nullable T ask(IntFunction<? extends Message.OfComponent> what, Request<T> request) {
    refuseInReplay();
    post(what.apply(last.incrementAndGet()), request, held.get());
    try {
      return request.future().get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException(Problem.WAIT_INTERRUPTED.text());
    } catch (ExecutionException e) {
      throw thrown(e.getCause());
    }
  }

  private void refuseInReplay() {
    if (interpreter.scheduler().journal().isReplay()) {
      throw new IllegalStateException(Problem.IN_REPLAY.text());
    }
  }

  private void post(Message.OfComponent asked, Request<?> request, @Nullable KernelLock lock) {
    pending.put(asked.number(), request);
    if (lock == null) {
      inbox.post(asked);
    } else {
      lock.ask(asked);
    }
    if (over) {
      // Unless that has been done already: it may be what the kernel has ended for.
      request.future().completeExceptionally(ended());
    }
  }

  private static RuntimeException thrown(@Nullable Throwable failure) {
    return failure instanceof RuntimeException e ? e : new IllegalStateException(failure);
  }

  /**
   * Locks the kernel: until {@link #unlock} it does only what this thread asks for.
   *
   * @throws IllegalStateException if the kernel has ended
   */
  void lock() {
    KernelLock present = held.get();
    if (present != null) {
      present.enter();
      return;
    }
    refuseInReplay();
    KernelLock made = new KernelLock(inbox);
    Request<Void> request = new Request<>(null, null, new CompletableFuture<>());
    post(new Message.KernelLocked(last.incrementAndGet(), made.receiver()), request, null);
    try {
      // Nobody may stop waiting for a lock that he will have.
      request.future().join();
      held.set(made);
    } catch (CancellationException e) {
      made.end();
      throw e;
    } catch (CompletionException e) {
      made.end();
      throw thrown(e.getCause());
    }
  }

  /** Ends what {@link #lock} began. */
  void unlock() {
    KernelLock present = held.get();
    if (present != null && present.end()) {
      held.remove();
    }
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Starts the job for a request. */
  void start(Message.OfComponent asked, UrbiObject lobby) {
    Request<?> request = find(asked);
    Scheduler scheduler = interpreter.scheduler();
    if (request == null) {
      scheduler.journal().missing(asked);
      return;
    }
    scheduler
        .startDetached(
            lobby,
            scheduler.rootScope(),
            "uobject",
            job -> {
              Frame frame = Frame.top(interpreter, job, lobby, new FrameLayout());
              if (asked instanceof Message.KernelLocked locked) {
                serve(frame, locked.lock(), request);
              } else {
                request.perform(frame, tasks, asked);
              }
            })
        .onEnd(() -> {
          pending.remove(asked.number());
          request.future().completeExceptionally(stopped());
        });
  }

  /** Does only what the owner of a lock asks for, until that unlocks it; in a job. */
  private void serve(Frame frame, int lock, Request<?> request) {
    // After the end of the job, the owner is served like everybody else.
    inbox.register(lock, message -> takeLate(message, frame.job().lobby()));
    inbox.takeAtOnce(lock);
    try {
      request.future().complete(null);
      Message message = next(frame, lock);
      while (message instanceof Message.AskedWhileLocked(int to, Message.OfComponent asked)) {
        perform(frame, asked);
        message = next(frame, lock);
      }
      if (message != null) {
        inbox.forget(lock);
      }
    } finally {
      inbox.endTakingAtOnce(lock);
    }
  }

  /** The wait is that of a component: whoever waits for too long is named and ended. */
  private @Nullable Message next(Frame frame, int lock) {
    ComponentCode waiting = frame.job().componentCode();
    String outer = waiting.enter("lock");
    try {
      return inbox.awaitAtOnce(lock);
    } finally {
      waiting.leave(outer);
    }
  }

  private void perform(Frame frame, Message.OfComponent asked) {
    Request<?> request = find(asked);
    if (request == null) {
      interpreter.scheduler().journal().missing(asked);
      return;
    }
    pending.remove(asked.number());
    request.perform(frame, tasks, asked);
  }

  private void takeLate(Message message, UrbiObject lobby) {
    if (message instanceof Message.AskedWhileLocked(int to, Message.OfComponent asked)) {
      start(asked, lobby);
    } else {
      inbox.forget(message.to());
    }
  }

  /** The request of a message. In a replay nobody waits for it, and it may need its thread. */
  private @Nullable Request<?> find(Message.OfComponent asked) {
    Request<?> request = pending.get(asked.number());
    if (request != null || asked instanceof Message.ComponentRequest) {
      return request;
    }
    PluggedSlot slot = tasks.variable(asked);
    return slot == null && asked instanceof Message.OfVariable
        ? null
        : new Request<>(slot, null, new CompletableFuture<>());
  }

  private static CancellationException stopped() {
    return new CancellationException("stopped");
  }

  static IllegalStateException ended() {
    return new ContextEndedException(Problem.KERNEL_ENDED.text());
  }

  /** The kernel has ended: fails all waiting requests. */
  void close() {
    over = true;
    pending.values().forEach(request -> request.future().completeExceptionally(ended()));
  }
}
