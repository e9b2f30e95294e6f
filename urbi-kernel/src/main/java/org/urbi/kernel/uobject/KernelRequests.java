package org.urbi.kernel.uobject;

import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Scheduler;
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
      } catch (RuntimeException | Error e) {
        future.completeExceptionally(e);
      }
    }
  }

  private final Interpreter interpreter;
  private final ComponentTasks tasks;
  private final AtomicInteger last = new AtomicInteger();
  private final Map<Integer, Request<?>> pending = new ConcurrentHashMap<>();
  private final ThreadLocal<KernelLock> held = new ThreadLocal<>();
  private volatile boolean over;

  KernelRequests(Interpreter interpreter, ComponentTasks tasks) {
    this.interpreter = interpreter;
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
    if (interpreter.scheduler().journal().isReplay()) {
      throw new IllegalStateException(Problem.IN_REPLAY.text());
    }
    CompletableFuture<T> future = request.future();
    Message.OfComponent asked = what.apply(last.incrementAndGet());
    pending.put(asked.number(), request);
    KernelLock hold = held.get();
    if (hold == null) {
      interpreter.scheduler().inbox().post(asked);
    } else {
      hold.add(frame -> {
        pending.remove(asked.number());
        request.perform(frame, tasks, asked);
      });
    }
    if (over) {
      // Unless that has been done already: it may be what the kernel has ended for.
      future.completeExceptionally(ended());
    }
    try {
      return future.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException(Problem.WAIT_INTERRUPTED.text());
    } catch (ExecutionException e) {
      throw switch (e.getCause()) {
        case RuntimeException failure -> failure;
        case Throwable other -> new IllegalStateException(other);
      };
    }
  }

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
            job ->
                request.perform(
                    Frame.top(interpreter, job, lobby, new FrameLayout()), tasks, asked))
        .onEnd(() -> {
          pending.remove(asked.number());
          request.future().completeExceptionally(new CancellationException("stopped"));
        });
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

  /** Locks the kernel: until {@link #unlock} it executes only requests of this thread. */
  void lock() {
    KernelLock present = held.get();
    if (present != null) {
      present.enter();
      return;
    }
    KernelLock made = new KernelLock(Thread.currentThread(), () -> over);
    CompletableFuture<Void> begun = new CompletableFuture<>();
    int number = last.incrementAndGet();
    pending.put(
        number,
        new Request<Void>(
            null,
            frame -> {
              begun.complete(null);
              made.serve(frame);
              return null;
            },
            begun));
    try {
      interpreter.scheduler().inbox().post(new Message.ComponentRequest(number));
      if (over) {
        throw ended();
      }
      begun.join();
      held.set(made);
    } finally {
      pending.remove(number);
    }
  }

  /** Ends what {@link #lock} began. */
  void unlock() {
    KernelLock present = held.get();
    if (present != null && present.end()) {
      held.remove();
    }
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
