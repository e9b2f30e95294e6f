package org.urbi.server.cli;

import java.io.PrintStream;
import java.time.Duration;
import java.util.function.IntConsumer;
import java.util.function.LongSupplier;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;

/**
 * Ends the process when nothing else can: when it was told to terminate and does not, when the
 * kernel or the network has not turned for long, when memory cannot be freed. It needs nothing that
 * may be missing then: its thread is there from the beginning.
 */
final class Watchdog {
  private static final long PERIOD_MILLISECONDS = 250;

  /** How long an orderly end may take, in nanoseconds. */
  private static final long TERMINATION = 4_000_000_000L;

  /** How long jobs that are ended have to free memory in, in nanoseconds. */
  private static final long RELIEF = 4_000_000_000L;

  private final Clock clock = new SystemClock();
  private final Memory memory = new Memory();
  private final Kernel kernel;
  private final LongSupplier networkSilence;
  private final long limit;
  private final PrintStream err;
  private final IntConsumer halt;
  private volatile long terminating;
  private volatile boolean over;
  private long tightSince;
  private boolean told;

  /**
   * @param networkSilence for how long the network thread has not turned, in nanoseconds
   * @param limit how long kernel and network may not turn; zero for as long as they like
   * @param halt ends the process with that status, at once
   */
  Watchdog(
      Kernel kernel,
      LongSupplier networkSilence,
      Duration limit,
      PrintStream err,
      IntConsumer halt) {
    this.kernel = kernel;
    this.networkSilence = networkSilence;
    this.limit = limit.isZero() ? Long.MAX_VALUE : limit.toNanos();
    this.err = err;
    this.halt = halt;
  }

  void start() {
    Thread thread = Thread.ofPlatform().daemon().name("urbi-watchdog").unstarted(this::watch);
    thread.setPriority(Thread.MAX_PRIORITY);
    thread.start();
  }

  /** The process was told to terminate: it does so soon, in any case. */
  void terminating() {
    terminating = clock.now();
  }

  /** There is nothing more to watch. */
  void stop() {
    over = true;
  }

  private void watch() {
    while (!over) {
      try {
        Thread.sleep(PERIOD_MILLISECONDS);
        look();
      } catch (InterruptedException e) {
        return;
      } catch (Throwable e) {
        // Memory is so short that not even a class can be loaded.
        exhausted();
      }
    }
  }

  private void look() throws InterruptedException {
    if (terminating != 0 && clock.now() - terminating > TERMINATION) {
      halt.accept(ExitStatus.TERMINATED);
    }
    if (memory.isTight()) {
      exhausted();
    } else {
      tightSince = 0;
    }
    lookAtKernel();
    long silence = networkSilence.getAsLong();
    if (silence > limit) {
      stuck("the network has not turned for " + seconds(silence) + " s");
    }
  }

  private void lookAtKernel() {
    long held = kernel.heldFor();
    if (held > limit) {
      stuck("the kernel has been held for " + seconds(held) + " s, by " + kernel.holder());
    } else if (held > limit / 4 && !told) {
      told = true;
      say("the kernel is held for " + seconds(held) + " s, by " + kernel.holder());
    } else if (held == 0) {
      told = false;
    }
  }

  private void stuck(String what) {
    say(what + "\nurbi: giving up");
    halt.accept(ExitStatus.STUCK);
  }

  private void exhausted() {
    try {
      if (tightSince == 0) {
        tightSince = clock.now();
        say("memory is nearly exhausted, ending what is done for " + kernel.relieve());
      } else if (clock.now() - tightSince > RELIEF) {
        say("memory exhausted, giving up");
        halt.accept(ExitStatus.MEMORY_EXHAUSTED);
      }
    } catch (Error e) {
      // Not even that can be said.
      if (clock.now() - tightSince > RELIEF) {
        halt.accept(ExitStatus.MEMORY_EXHAUSTED);
      }
    } catch (InterruptedException e) {
      over = true;
    }
  }

  private void say(String text) {
    err.println("urbi: " + text);
  }

  private static double seconds(long nanoseconds) {
    return nanoseconds / 100_000_000 / 10.0;
  }
}
