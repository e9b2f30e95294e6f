package org.urbi.ros.rcl;

import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import urbi.thread.GuardedThreads;

/**
 * What the middleware tells that something has come. It does so on threads of its own, which hold
 * its locks: they only leave word here, and a thread of the node takes what has come.
 */
final class Arrivals implements AutoCloseable {
  private static final Map<Long, Source> SOURCES = new ConcurrentHashMap<>();
  private static final AtomicLong NUMBERS = new AtomicLong();

  /**
   * The only function that C ever calls. It is never taken away, so that what is told too late
   * finds nobody instead of nothing.
   */
  private static final MemorySegment CALLBACK = callback();

  private static final Executor PATIENT = GuardedThreads.SDK.virtualThreads("urbi-ros-rcl-patient");

  private final BlockingQueue<Source> rung = new LinkedBlockingQueue<>();
  private final Consumer<Throwable> troubles;
  private final Source end = new Source(() -> {}, Runnable::run);

  /**
   * @param troubles are told what the work of sources throws
   */
  Arrivals(Consumer<Throwable> troubles) {
    this.troubles = troubles;
    GuardedThreads.SDK.platform("urbi-ros-rcl", this::work).start();
  }

  // C is given nothing else to call, and that with its signature.
  @SuppressWarnings("restricted")
  private static MemorySegment callback() {
    try {
      return Linker.nativeLinker()
          .upcallStub(
              MethodHandles.lookup()
                  .findStatic(
                      Arrivals.class,
                      "arrived",
                      MethodType.methodType(void.class, long.class, long.class)),
              FunctionDescriptor.ofVoid(ValueLayout.JAVA_LONG, ValueLayout.JAVA_LONG),
              Arena.global());
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  /** Called by C, in which nothing may be thrown. */
  private static void arrived(long number, long count) {
    Source source = SOURCES.get(number);
    if (source != null) source.ring();
  }

  private void work() {
    try {
      for (Source next = rung.take(); next != end; next = rung.take()) next.run();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Something from which messages come. */
  Source source(Runnable work) {
    return new Source(work, Runnable::run);
  }

  /** Something whose work may wait, in a thread of its own. */
  Source patientSource(Runnable work) {
    return new Source(work, PATIENT);
  }

  /** Nothing is taken any more. */
  @Override
  public void close() {
    rung.add(end);
  }

  /** Something from which messages come. */
  final class Source implements AutoCloseable {
    private final long number = NUMBERS.incrementAndGet();
    private final AtomicBoolean isRung = new AtomicBoolean();
    private final ReentrantLock turn = new ReentrantLock();
    private final Runnable work;
    private final Executor executor;

    private Source(Runnable work, Executor executor) {
      this.work = work;
      this.executor = executor;
      SOURCES.put(number, this);
    }

    /** Has its work done by the thread of the node, soon. */
    void ring() {
      if (isRung.compareAndSet(false, true)) rung.add(this);
    }

    private void run() {
      try {
        executor.execute(this::doWork);
      } catch (RuntimeException | Error e) {
        // No thread can be made now: it is taken with what comes next.
        isRung.set(false);
        troubles.accept(e);
      }
    }

    private void doWork() {
      turn.lock();
      isRung.set(false);
      try {
        work.run();
      } catch (Throwable e) {
        troubles.accept(e);
      } finally {
        turn.unlock();
      }
    }

    /** Has it rung by what a function of C announces. */
    void hear(CFunctions c, String function, MemorySegment entity) {
      c.check(function, entity, CALLBACK, MemorySegment.ofAddress(number));
    }

    @Override
    public void close() {
      SOURCES.remove(number);
    }
  }
}
