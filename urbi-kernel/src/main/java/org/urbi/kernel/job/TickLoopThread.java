package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;

/**
 * A job on a virtual thread whose scheduler is the tick loop. The thread hands its continuation to
 * this object, as its executor; the loop runs that continuation on its own platform thread when the
 * turn of the job has come.
 *
 * <p>It leaves that thread only in {@link #suspend}. If it waits in Java, for a lock or for a class
 * that is being loaded, the loop waits with it: otherwise the lock would be kept for a job that
 * runs again only when the loop, which may be the next to want it, has gone on.
 */
final class TickLoopThread implements JobThread, Executor, Runnable {
  private static final @Nullable MethodHandle NEW_BUILDER = findBuilder();

  /** What executes the virtual threads of the program. */
  private static final @Nullable Executor OTHERS = findOthers();

  /**
   * To try in vain whether a stack can be put away takes a walk through all of it, so the next try
   * comes after so many times the time that the last one has taken.
   */
  private static final int PAUSES = 4;

  private final Factory factory;
  private final Job job;
  private final Thread thread;
  private @Nullable Runnable own;
  private @Nullable Runnable continuation;
  private boolean started;
  private boolean resumed;

  /** The thread that runs the continuation, or has run it last. */
  private @Nullable Thread carrier;

  /** Whether it has kept that thread, because its stack could not be put away. */
  private boolean keeping;

  /** Then whether it has been lent the turn. */
  private volatile boolean lent;

  /** When it is tried again to put its stack away, in nanoseconds of the machine. */
  private long nextTry;

  private TickLoopThread(Factory factory, Job job) {
    this.factory = factory;
    this.job = job;
    thread = newVirtual(this, this);
  }

  @Override
  public void run() {
    KernelThreadPin.pin();
    try {
      job.run();
    } finally {
      KernelThreadPin.unpin();
    }
  }

  private static Thread newVirtual(Executor scheduler, Runnable body) {
    try {
      Thread.Builder.OfVirtual builder =
          (Thread.Builder.OfVirtual)
              requireNonNull(NEW_BUILDER, "the factory has looked").invokeExact(scheduler);
      return builder.unstarted(body);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * The JDK has no public way to choose the scheduler of a virtual thread; its builder has, and is
   * reached when {@code --add-opens java.base/java.lang=ALL-UNNAMED} opens the package.
   */
  private static @Nullable MethodHandle findBuilder() {
    try {
      Class<?> builder = Class.forName("java.lang.ThreadBuilders$VirtualThreadBuilder");
      var constructor = builder.getDeclaredConstructor(Executor.class);
      constructor.setAccessible(true);
      return MethodHandles.lookup()
          .unreflectConstructor(constructor)
          .asType(MethodType.methodType(Thread.Builder.OfVirtual.class, Executor.class));
    } catch (ReflectiveOperationException | RuntimeException e) {
      return null;
    }
  }

  private static @Nullable Executor findOthers() {
    try {
      var getter = Class.forName("java.lang.VirtualThread").getDeclaredMethod("defaultScheduler");
      getter.setAccessible(true);
      return (Executor)
          MethodHandles.lookup()
              .unreflect(getter)
              .asType(MethodType.methodType(Executor.class))
              .invokeExact();
    } catch (ReflectiveOperationException | RuntimeException e) {
      return null;
    } catch (Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }

  static boolean isAvailable() {
    return NEW_BUILDER != null && OTHERS != null && KernelThreadPin.isAvailable();
  }

  @Override
  public void execute(Runnable task) {
    if (own == null) {
      own = task;
    }
    if (task == own) {
      continuation = task;
    } else {
      // A virtual thread started by code that a job has called: it is not a job, but has inherited
      // this scheduler. The common pool is no place for it. That has one thread on two processors,
      // which a task there blocks that waits for a lock; if this thread has the lock, for ever.
      requireNonNull(OTHERS, "the factory has looked").execute(task);
    }
  }

  @Override
  public void resume() {
    if (keeping) {
      lendTurn();
    } else {
      runHere();
    }
  }

  private void runHere() {
    carrier = Thread.currentThread();
    resumed = true;
    if (!started) {
      started = true;
      thread.start();
    }
    Runnable next = requireNonNull(continuation, "it can run");
    continuation = null;
    next.run();
    if (!factory.threads.isLoop()) {
      // The job had kept this thread, and the loop goes on elsewhere.
      endKeeping();
      factory.threads.leaveKept();
      throw new LoopMoved();
    }
  }

  private void lendTurn() {
    factory.threads.lend(requireNonNull(carrier, "it has kept it"), this::goOn);
  }

  private void goOn() {
    lent = true;
    LockSupport.unpark(thread);
  }

  @Override
  public void suspend() {
    if (factory.ended) {
      throw TagStop.WHOLE_JOB;
    }
    if (keeping && job.calls() <= Job.DEEP && job.scheduler().machine().now() - nextTry < 0) {
      stay();
      return;
    }
    long begun = keeping ? job.scheduler().machine().now() : 0;
    resumed = false;
    try {
      yieldUnpinned();
    } catch (StackOverflowError e) {
      refused(begun, e);
      return;
    }
    job.forgetCalls();
    if (!resumed) {
      throw new IllegalStateException("a job cannot wait inside a native call");
    }
  }

  /** Hands the continuation to {@link #execute}, and returns when the loop has run it again. */
  private static void yieldUnpinned() {
    KernelThreadPin.unpin();
    try {
      Thread.yield();
    } finally {
      KernelThreadPin.pin();
    }
  }

  /**
   * The stack is too large to be put away: with G1, larger than half of a region of the heap. In
   * very many calls it keeps no thread, whose stack each collection of garbage would look through.
   */
  private void refused(long begun, StackOverflowError refusal) {
    long now = job.scheduler().machine().now();
    if (job.calls() > Job.DEEP) {
      throw refusal;
    }
    if (keeping) {
      nextTry = now + PAUSES * (now - begun);
      stay();
      return;
    }
    if (job.scheduler().isStopped() || !factory.hasThreadToKeepFor(job.account())) {
      throw refusal;
    }
    nextTry = now;
    lent = false;
    keeping = true;
    factory.keepers.add(this);
    if (!factory.threads.keep()) {
      endKeeping();
      throw refusal;
    }
    awaitTurn();
  }

  private void endKeeping() {
    keeping = false;
    factory.keepers.remove(this);
  }

  private void stay() {
    lent = false;
    factory.threads.giveBack();
    awaitTurn();
  }

  /** Others have the turn, so nothing may be touched that they touch. */
  private void awaitTurn() {
    boolean interrupted = false;
    while (!lent) {
      LockSupport.park(this);
      // Parking would not wait any more.
      interrupted |= Thread.interrupted();
    }
    if (interrupted) {
      thread.interrupt();
    }
    if (factory.ended) {
      throw TagStop.WHOLE_JOB;
    }
  }

  @Override
  public void interrupt() {
    thread.interrupt();
  }

  @Override
  public StackTraceElement[] stackTrace() {
    return thread.getStackTrace();
  }

  @Override
  public boolean isCurrent() {
    return Thread.currentThread() == thread;
  }

  /** Makes the threads of one kernel. */
  static final class Factory implements JobThread.Factory {
    /** The stack of the loop's thread, for deep recursion; the system provides it page by page. */
    private static final long STACK_BYTES = 512L << 20;

    private static final int MAXIMUM_DEPTH = 200_000;

    private final LoopThreads threads = new LoopThreads(body -> newThread(body, "urbi-kernel"));

    /** Those that have kept their threads; for whoever has the turn. */
    private final Set<TickLoopThread> keepers = new HashSet<>();

    private volatile boolean ended;

    Factory() {
      if (!isAvailable()) {
        throw new IllegalStateException(
            "java.lang is closed: run java with --add-opens java.base/java.lang=ALL-UNNAMED");
      }
    }

    /**
     * Loads what the end of a virtual thread uses, by ending one. If a thousand jobs fall asleep
     * before any has ended, the JVM compiles what they do without its end, which it does not know
     * yet, and has to give up that code for each of them when it has slept. To be called on the
     * loop's thread: whoever starts a kernel may be a virtual thread, on which no other can run.
     */
    private static void loadWhatEnds() {
      newVirtual(Runnable::run, () -> {}).start();
    }

    /**
     * Whether another job may keep its thread. A lobby has at most half of those that others leave
     * to it, rounded up, so that one alone does not take them all.
     */
    private boolean hasThreadToKeepFor(Budget account) {
      long own = keepers.stream().filter(keeper -> keeper.job.account() == account).count();
      long left = LoopThreads.MOST_KEPT - (keepers.size() - own);
      return own < (left + 1) / 2;
    }

    @Override
    public JobThread create(Job job) {
      return new TickLoopThread(this, job);
    }

    @Override
    public Thread startLoop(Runnable body) {
      return threads.start(() -> {
        loadWhatEnds();
        body.run();
      });
    }

    /** Jobs that have kept their threads still have to be left. */
    @Override
    public void loopEnded() {
      ended = true;
      if (!keepers.isEmpty()) {
        List<TickLoopThread> last = List.copyOf(keepers);
        newThread(() -> last.forEach(TickLoopThread::lendTurn), "urbi-kernel-late").start();
      }
    }

    private static Thread newThread(Runnable body, String name) {
      Thread thread = new Thread(null, body, name, STACK_BYTES);
      // Like virtual threads, the loop's thread is a daemon: a kernel does not keep the program
      // running.
      thread.setDaemon(true);
      return thread;
    }

    @Override
    public long processorTime() {
      return threads.processorTime();
    }

    @Override
    public long allocatedBytes() {
      return threads.allocatedBytes();
    }

    @Override
    public int maximumDepth() {
      return MAXIMUM_DEPTH;
    }
  }
}
