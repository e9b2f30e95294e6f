package org.urbi.ros.rtps;

import java.util.Queue;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BiConsumer;
import org.urbi.ros.time.SteadyClock;
import urbi.thread.GuardedThreads;

/**
 * The lock of a participant, its timers, and the calls to its listeners. Nothing runs while no
 * timer is due and nothing arrives.
 */
final class Reactor {
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition wake = lock.newCondition();
  private final TreeSet<Timer> timers = new TreeSet<>();
  private final Queue<Runnable> calls = new ConcurrentLinkedQueue<>();
  private final ReentrantLock calling = new ReentrantLock();
  private final BiConsumer<String, Throwable> trouble;
  private final Thread thread;
  private volatile Thread adopted;
  private Runnable leaving = () -> {};
  private long serial;
  private long sleepsUntil;
  private boolean sleeping;
  private boolean closed;

  /** {@code trouble} is told what a timer or a listener throws. */
  Reactor(String name, BiConsumer<String, Throwable> trouble) {
    this.trouble = trouble;
    thread = GuardedThreads.SDK.platform(name, this::run);
    adopted = thread;
  }

  void start() {
    thread.start();
  }

  /** Timers end; calls that wait are still made. */
  void close() {
    lock.lock();
    try {
      closed = true;
      wake.signalAll();
    } finally {
      lock.unlock();
    }
  }

  void lock() {
    lock.lock();
  }

  /** The thread that receives leaves it without a word: it has calls to make first. */
  void unlock() {
    try {
      if (lock.getHoldCount() == 1 && Thread.currentThread() != adopted) leaving.run();
    } finally {
      lock.unlock();
    }
  }

  Condition newCondition() {
    return lock.newCondition();
  }

  /** Is done, with the lock, whenever that is about to be left. */
  void beforeLeaving(Runnable action) {
    leaving = action;
  }

  /** A thread that will wait for a condition is about to leave the lock. */
  void leave() {
    leaving.run();
  }

  /** That thread calls {@link #settle} itself after whatever it does. */
  void adopt(Thread other) {
    adopted = other;
  }

  /** Whether the calling thread is one of the two of the participant. */
  boolean isCurrent() {
    Thread current = Thread.currentThread();
    return current == thread || current == adopted;
  }

  /**
   * Makes a call after the lock has been left, by one of the two threads of the participant, in the
   * order of these calls.
   */
  void later(Runnable call) {
    calls.add(call);
    if (!isCurrent()) wakeUp();
  }

  /** Makes the calls that wait, and does then what is due when the lock is left. */
  void settle() {
    makeCalls();
    lock.lock();
    try {
      leaving.run();
    } finally {
      lock.unlock();
    }
  }

  /** Makes the calls that wait, unless another thread is at it. Never with the lock. */
  private void makeCalls() {
    while (!calls.isEmpty() && calling.tryLock()) {
      try {
        Runnable call = calls.poll();
        if (call != null) call.run();
      } catch (Throwable e) {
        trouble.accept("a listener failed", e);
      } finally {
        calling.unlock();
      }
    }
  }

  private void wakeUp() {
    lock.lock();
    try {
      wake.signal();
    } finally {
      lock.unlock();
    }
  }

  Timer timer(String what, Runnable action) {
    return new Timer(what, action, serial++);
  }

  private void run() {
    boolean goesOn = true;
    while (goesOn) {
      try {
        goesOn = step();
        makeCalls();
      } catch (Throwable e) {
        trouble.accept("a timer failed", e);
      }
    }
  }

  private boolean step() throws InterruptedException {
    lock.lock();
    try {
      if (closed) return false;
      long now = SteadyClock.nanoseconds();
      if (!timers.isEmpty() && timers.first().due - now <= 0) {
        Timer first = timers.first();
        first.cancel();
        first.fire();
        leaving.run();
      } else if (calls.isEmpty()) {
        sleepsUntil = timers.isEmpty() ? now + TimeUnit.HOURS.toNanos(1) : timers.first().due;
        sleeping = true;
        wake.awaitNanos(sleepsUntil - now);
        sleeping = false;
      }
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** An action that runs with the lock when it is due, once. */
  final class Timer implements Comparable<Timer> {
    private final String what;
    private final Runnable action;
    private final long number;
    private long due;
    private boolean isSet;

    private Timer(String what, Runnable action, long number) {
      this.what = what;
      this.action = action;
      this.number = number;
    }

    boolean isSet() {
      return isSet;
    }

    /** Sets it to so many nanoseconds from now, wherever it was. */
    void in(long nanos) {
      at(SteadyClock.nanoseconds() + nanos);
    }

    /** Sets it, unless it comes earlier anyway. */
    void atLatestIn(long nanos) {
      long time = SteadyClock.nanoseconds() + nanos;
      if (!isSet || due - time > 0) at(time);
    }

    private void at(long time) {
      cancel();
      due = time;
      isSet = true;
      timers.add(this);
      if (sleeping && due - sleepsUntil < 0) wake.signal();
    }

    void cancel() {
      if (isSet) timers.remove(this);
      isSet = false;
    }

    private void fire() {
      try {
        action.run();
      } catch (Throwable e) {
        trouble.accept("failed: " + what, e);
      }
    }

    @Override
    public int compareTo(Timer other) {
      int order = Long.compare(due - other.due, 0);
      return order != 0 ? order : Long.compare(number, other.number);
    }

    @Override
    public boolean equals(Object other) {
      return this == other;
    }

    @Override
    public int hashCode() {
      return Long.hashCode(number);
    }
  }
}
