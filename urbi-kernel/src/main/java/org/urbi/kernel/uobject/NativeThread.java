package org.urbi.kernel.uobject;

import static java.util.Objects.requireNonNull;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.log.FailureLog;
import urbi.UContext;

/**
 * The thread of native code that yields in the middle of a call. A native frame cannot leave the
 * thread that it is on: on the kernel thread it would hold all jobs.
 *
 * <p>Only one of the two threads runs at a time. A job that calls native code occupies the kernel
 * thread, executes the requests of that code in between, and waits like any other job when such a
 * request makes it wait. Other jobs may call native code then: their calls are on top of the first
 * one, which goes on when they have returned.
 */
final class NativeThread {
  /** The thread's stack, for calls on top of calls; the system provides it page by page. */
  private static final long STACK_BYTES = 64L << 20;

  /**
   * What has come of code that one of the two threads has executed for the other.
   *
   * @param failure what it has thrown, or null
   */
  private record Handed(@Nullable Object value, @Nullable Throwable failure) {
    static Handed of(Supplier<?> code) {
      try {
        return new Handed(code.get(), null);
      } catch (Throwable e) {
        return new Handed(null, e);
      }
    }
  }

  /** What the kernel thread gives this one to do. */
  private sealed interface Order {}

  /** A new call, on top of the others. */
  private record Begin(Supplier<?> code) implements Order {}

  /** What came of a request: the call on top goes on. */
  private record Answer(Handed outcome) implements Order {}

  private record End() implements Order {}

  /** What this thread gives the kernel thread. */
  private sealed interface Step {}

  /** The call on top has returned. */
  private record Returned(Handed outcome) implements Step {}

  /** The call on top wants something of the kernel. */
  private record Request(Supplier<?> task) implements Step {}

  /** A call that has not returned; used on the kernel thread. */
  private static final class Call {
    /** The job, while it waits until the call is on top; null while it does not. */
    @Nullable Job waiting;

    /** What has ended the job of the call; null if it lives. */
    @Nullable Throwable ended;
  }

  /** Makes the thread; a test has it fail. */
  interface Maker {
    /**
     * A thread that is not started yet.
     *
     * @param failed is told what has ended it
     */
    Thread make(Runnable body, Consumer<Throwable> failed);
  }

  private final PluggedContext context;
  private final Maker maker;
  private final BlockingQueue<Order> orders = new LinkedBlockingQueue<>();
  private final BlockingQueue<Step> steps = new LinkedBlockingQueue<>();
  private final Deque<Call> calls = new ArrayDeque<>();
  private volatile @Nullable Thread thread;

  /** What has ended the thread, and with it the calls that have not returned; null if it lives. */
  private volatile @Nullable Throwable defect;

  NativeThread(PluggedContext context) {
    this(
        context,
        (body, failed) -> FailureLog.THREADS.platform("urbi-component", STACK_BYTES, body, failed));
  }

  NativeThread(PluggedContext context, Maker maker) {
    this.context = context;
    this.maker = maker;
  }

  /** Whether the calling code runs on this thread. */
  boolean isCurrent() {
    return Thread.currentThread() == thread;
  }

  // ------------------------------------------------------------------ the kernel thread

  /** Executes code on this thread, for which the kernel thread waits unless the code yields. */
  @SuppressWarnings("unchecked") // the outcome is that of the code
  <T> T execute(Supplier<T> code) {
    if (calls.isEmpty() && defect != null) {
      forgetEnded();
    }
    Throwable ended = defect;
    if (ended != null) {
      return (T) requireNonNull(result(new Handed(null, ended)), "it throws");
    }
    if (thread == null) {
      start();
    }
    Call call = new Call();
    calls.push(call);
    orders.add(new Begin(code));
    return (T) requireNonNull(result(serve(call)), "native code returns something");
  }

  private void start() {
    Thread made = maker.make(this::work, this::failed);
    made.start();
    // Only now: if there can be no more threads, the next call tries again.
    thread = made;
  }

  /** The kernel thread would wait for the call on top for ever; on the thread that ends. */
  private void failed(Throwable what) {
    defect = what;
    steps.add(new Returned(new Handed(null, what)));
  }

  /** The next call has a thread of its own. */
  private void forgetEnded() {
    thread = null;
    orders.clear();
    steps.clear();
    defect = null;
  }

  private static @Nullable Object result(Handed outcome) {
    switch (outcome.failure()) {
      case null -> {
        return outcome.value();
      }
      case RuntimeException failure -> throw failure;
      case Error failure -> throw failure;
      case Throwable failure -> throw new IllegalStateException(failure);
    }
  }

  /** Executes what the call on top asks for, until it has returned. */
  private Handed serve(Call call) {
    while (true) {
      switch (uninterruptibly(steps)) {
        case Returned step -> {
          return returned(step.outcome());
        }
        case Request step -> {
          Handed answer = perform(call, step.task());
          Throwable ended = defect;
          if (ended != null) {
            return returned(new Handed(null, ended));
          }
          orders.add(new Answer(answer));
        }
      }
    }
  }

  private Handed returned(Handed outcome) {
    calls.pop();
    passTurn();
    return outcome;
  }

  /** Executes a request, which may let others run, and waits until its call is on top again. */
  private Handed perform(Call call, Supplier<?> task) {
    Handed outcome;
    try {
      outcome = Handed.of(task);
      awaitTurn(call);
    } catch (ControlFlowException e) {
      outcome = new Handed(null, e);
    }
    if (outcome.failure() instanceof ControlFlowException e && calls.peek() != call) {
      // The job ends now. The call has to wait until it is on top.
      call.ended = e;
      throw e;
    }
    return outcome;
  }

  private void awaitTurn(Call call) {
    if (calls.peek() == call) {
      return;
    }
    KernelCrossing crossing = context.crossing();
    crossing.inKernel(frame -> {
      call.waiting = frame.job();
      try {
        while (calls.peek() != call) {
          frame.job().waitForWake(Wait.COMPONENT);
        }
      } finally {
        call.waiting = null;
      }
      return null;
    });
  }

  /** A call has returned: the one below goes on, or is ended if its job has been. */
  private void passTurn() {
    Call top = calls.peek();
    if (top == null) {
      return;
    }
    if (top.ended != null) {
      Handed answer = new Handed(null, top.ended);
      if (defect == null) {
        orders.add(new Answer(answer));
        serve(top);
      } else {
        returned(answer);
      }
    } else if (top.waiting != null) {
      top.waiting.wake();
    }
  }

  /** The kernel has ended; on its thread. */
  void close() {
    if (calls.isEmpty()) {
      orders.add(new End());
    }
  }

  /** Takes the next one. */
  private static <T> T uninterruptibly(BlockingQueue<T> from) {
    boolean interrupted = false;
    try {
      while (true) {
        try {
          return from.take();
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  // ------------------------------------------------------------------ this thread

  /** Has the kernel thread execute a request of the code that runs here. */
  @SuppressWarnings("unchecked") // the outcome is that of the task
  <T> @Nullable T ask(Supplier<? extends @Nullable T> task) {
    steps.add(new Request(task));
    return (T) result(requireNonNull(executeUntilAnswer(), "it ends only when nothing is called"));
  }

  private void work() {
    UContext.enter(context);
    executeUntilAnswer();
  }

  /** Executes calls on top of the present one until that goes on; null at the end. */
  private @Nullable Handed executeUntilAnswer() {
    while (true) {
      switch (uninterruptibly(orders)) {
        case Begin order -> steps.add(new Returned(Handed.of(order.code())));
        case Answer order -> {
          return order.outcome();
        }
        case End order -> {
          return null;
        }
      }
    }
  }
}
