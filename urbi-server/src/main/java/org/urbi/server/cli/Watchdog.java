package org.urbi.server.cli;

import java.io.PrintStream;
import java.time.Duration;
import java.util.function.IntConsumer;
import java.util.function.LongSupplier;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.log.WatchFailure;
import org.urbi.kernel.time.Clock;

/**
 * Ends the process when nothing else can: when it does not terminate as requested, when the kernel
 * or the network thread is blocked for long. Its thread exists from the start, because none could
 * be made when memory is exhausted.
 */
final class Watchdog {
  private static final long PERIOD_MILLISECONDS = 250;

  /** How long an orderly end may take, in nanoseconds. */
  private static final long TERMINATION = 4_000_000_000L;

  private final Clock clock;
  private final Kernel kernel;
  private final LongSupplier networkSilence;
  private final long limit;
  private final PrintStream err;
  private final IntConsumer halt;
  private volatile long terminating;
  private volatile boolean over;
  private boolean told;
  private final WatchFailure failure = new WatchFailure("the watchdog");

  /**
   * @param clock real time
   * @param networkSilence how long the network thread has been blocked, in nanoseconds
   * @param limit how long kernel and network may not turn; zero for as long as they like
   * @param err never blocks
   * @param halt ends the process with that status, at once
   */
  Watchdog(
      Clock clock,
      Kernel kernel,
      LongSupplier networkSilence,
      Duration limit,
      PrintStream err,
      IntConsumer halt) {
    this.clock = clock;
    this.kernel = kernel;
    this.networkSilence = networkSilence;
    this.limit = limit.isZero() ? Long.MAX_VALUE : limit.toNanos();
    this.err = err;
    this.halt = halt;
  }

  void start() {
    Thread thread = FailureLog.THREADS.platform("urbi-watchdog", this::watch);
    thread.setPriority(Thread.MAX_PRIORITY);
    thread.start();
  }

  /** The process was asked to terminate: from now on it ends soon, in any case. */
  void terminating() {
    terminating = clock.now();
  }

  /**
   * Stops watching a kernel that has ended. Who was asked to terminate is watched until it is gone:
   * what the process does after its last kernel may never end either.
   */
  void stop() {
    over = terminating == 0;
  }

  private void watch() {
    while (!over) {
      try {
        Thread.sleep(PERIOD_MILLISECONDS);
        check();
      } catch (InterruptedException e) {
        return;
      } catch (RuntimeException | VirtualMachineError | LinkageError e) {
        // Perhaps there is so little memory that not even a class can be loaded; the kernel sees to
        // that.
        failure.met(e);
      }
    }
  }

  private void check() {
    if (terminating != 0 && clock.now() - terminating > TERMINATION) {
      halt.accept(ExitStatus.TERMINATED);
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
      err.println("urbi: the kernel is held for " + seconds(held) + " s, by " + kernel.holder());
    } else if (held == 0) {
      told = false;
    }
  }

  private void stuck(String what) {
    err.println("urbi: " + what + "\nurbi: giving up");
    halt.accept(ExitStatus.STUCK);
  }

  private static double seconds(long nanoseconds) {
    return nanoseconds / 100_000_000 / 10.0;
  }
}
