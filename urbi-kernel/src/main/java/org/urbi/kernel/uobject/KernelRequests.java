package org.urbi.kernel.uobject;

import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
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
  private record Request<T>(Function<Frame, T> task, CompletableFuture<T> future) {
    /** Executes it; in a job. */
    void perform(Frame frame) {
      try {
        future.complete(task.apply(frame));
      } catch (RuntimeException | Error e) {
        future.completeExceptionally(e);
      }
    }
  }

  private final Interpreter interpreter;
  private final AtomicInteger last = new AtomicInteger();
  private final Map<Integer, Request<?>> pending = new ConcurrentHashMap<>();
  private final ThreadLocal<KernelLock> held = new ThreadLocal<>();
  private volatile boolean over;

  KernelRequests(Interpreter interpreter) {
    this.interpreter = interpreter;
  }

  /**
   * Executes a task in a job, and waits.
   *
   * @throws IllegalStateException if the kernel has ended
   * @throws CancellationException if the thread is interrupted
   */
  <T> T ask(Function<Frame, T> task) {
    if (interpreter.scheduler().journal().isReplay()) {
      throw new IllegalStateException(Problem.IN_REPLAY.text());
    }
    CompletableFuture<T> future = new CompletableFuture<>();
    Request<T> request = new Request<>(task, future);
    int number = last.incrementAndGet();
    pending.put(number, request);
    KernelLock hold = held.get();
    try {
      if (hold == null) {
        interpreter.scheduler().inbox().post(new Message.ComponentRequest(number));
      } else {
        hold.add(request::perform);
      }
      if (over) {
        // Unless that has been done already: it may be what the kernel has ended for.
        future.completeExceptionally(ended());
      }
      return future.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException(Problem.WAIT_INTERRUPTED.text());
    } catch (ExecutionException e) {
      throw switch (e.getCause()) {
        case RuntimeException failure -> failure;
        case Throwable other -> new IllegalStateException(other);
      };
    } finally {
      pending.remove(number);
    }
  }

  /** Starts the job for a request; false if nobody waits for it any more. */
  boolean start(int number, UrbiObject lobby) {
    Request<?> request = pending.get(number);
    if (request == null) {
      return false;
    }
    Scheduler scheduler = interpreter.scheduler();
    scheduler
        .startDetached(
            lobby,
            scheduler.rootScope(),
            "uobject",
            job -> request.perform(Frame.top(interpreter, job, lobby, new FrameLayout())))
        .onEnd(() -> request.future().completeExceptionally(new CancellationException("stopped")));
    return true;
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
