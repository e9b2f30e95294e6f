package org.urbi.server.cli;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.LongSupplier;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.time.Clock;

/**
 * Ends the process when nothing else can: when it does not terminate as requested, when the kernel
 * or the network thread is blocked for long, when memory cannot be freed. Its thread exists from
 * the start, because none could be made when memory is exhausted.
 */
final class Watchdog {
  private static final long PERIOD_MILLISECONDS = 250;

  /** How long an orderly end may take, in nanoseconds. */
  private static final long TERMINATION = 4_000_000_000L;

  /** How long ended jobs have to free their memory, in nanoseconds. */
  private static final long RELIEF = 4_000_000_000L;

  /** The time until the next lobby is ended, in nanoseconds. */
  private static final long NEXT_RELIEF = 1_000_000_000;

  /** How long freeing memory may take in all, in nanoseconds. */
  private static final long MAX_RELIEF = 20_000_000_000L;

  /** Made beforehand: when it is needed, there may be no memory to make it with. */
  private static final byte[] GIVING_UP =
      "urbi: memory exhausted, giving up\n".getBytes(StandardCharsets.US_ASCII);

  private final Clock clock;
  private final HeapUsage memory = new HeapUsage();
  private final Kernel kernel;
  private final LongSupplier networkSilence;
  private final long limit;
  private final PrintStream err;
  private final IntConsumer halt;
  private final Consumer<Boolean> onNearlyFull;
  private volatile long terminating;
  private volatile boolean over;
  private long nearlyFullSince;
  private int relieved;
  private long relievedAt;
  private boolean told;

  /**
   * @param clock real time
   * @param networkSilence how long the network thread has been blocked, in nanoseconds
   * @param limit how long kernel and network may not turn; zero for as long as they like
   * @param onNearlyFull told when memory is nearly exhausted, and when it is not any more
   * @param halt ends the process with that status, at once
   */
  Watchdog(
      Clock clock,
      Kernel kernel,
      LongSupplier networkSilence,
      Duration limit,
      PrintStream err,
      Consumer<Boolean> onNearlyFull,
      IntConsumer halt) {
    this.clock = clock;
    this.kernel = kernel;
    this.networkSilence = networkSilence;
    this.limit = limit.isZero() ? Long.MAX_VALUE : limit.toNanos();
    this.err = err;
    this.onNearlyFull = onNearlyFull;
    this.halt = halt;
  }

  void start() {
    Thread thread = Thread.ofPlatform().daemon().name("urbi-watchdog").unstarted(this::watch);
    thread.setPriority(Thread.MAX_PRIORITY);
    thread.start();
  }

  /** The process was asked to terminate: from now on it ends soon, in any case. */
  void terminating() {
    terminating = clock.now();
  }

  /** Stops watching. */
  void stop() {
    over = true;
  }

  private void watch() {
    while (!over) {
      try {
        Thread.sleep(PERIOD_MILLISECONDS);
        check();
      } catch (InterruptedException e) {
        return;
      } catch (VirtualMachineError | LinkageError e) {
        // There is so little memory that not even a class can be loaded.
        exhausted();
      }
    }
  }

  private void check() throws InterruptedException {
    if (terminating != 0 && clock.now() - terminating > TERMINATION) {
      halt.accept(ExitStatus.TERMINATED);
    }
    lookAtMemory();
    lookAtKernel();
    long silence = networkSilence.getAsLong();
    if (silence > limit) {
      stuck("the network has not turned for " + seconds(silence) + " s");
    }
  }

  private void lookAtMemory() {
    boolean scarce = memory.isScarce();
    kernel.memoryScarce(scarce);
    if (!scarce) {
      memory.forget();
    }
    if (scarce && memory.isNearlyFull(clock.now())) {
      exhausted();
    } else if (nearlyFullSince != 0) {
      nearlyFullSince = 0;
      onNearlyFull.accept(false);
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
      if (nearlyFullSince == 0) {
        nearlyFullSince = clock.now();
        relievedAt = nearlyFullSince;
        relieved = 0;
        onNearlyFull.accept(true);
      }
      long now = clock.now();
      if (now - relievedAt > RELIEF || now - nearlyFullSince > MAX_RELIEF) {
        giveUp();
      } else if ((relieved == 0 || now - relievedAt >= NEXT_RELIEF) && !isRelieved()) {
        evictLargest();
      }
    } catch (Error e) {
      if (clock.now() - nearlyFullSince > RELIEF) {
        giveUp();
      }
    } catch (InterruptedException e) {
      over = true;
    }
  }

  /** Says so without making anything, and ends the process even if that fails. */
  private void giveUp() {
    try {
      err.write(GIVING_UP, 0, GIVING_UP.length);
      err.flush();
    } finally {
      halt.accept(ExitStatus.MEMORY_EXHAUSTED);
    }
  }

  private void evictLargest() throws InterruptedException {
    String done = kernel.evictLargest();
    if (!done.isEmpty()) {
      relieved++;
      relievedAt = clock.now();
      say("memory is nearly exhausted, " + done);
    }
  }

  /**
   * Whether the lobbies that were ended have freed enough memory; asks for a garbage collection,
   * which nobody else would do soon.
   */
  private boolean isRelieved() {
    if (relieved > 0) {
      System.gc();
    }
    return relieved > 0 && !(memory.isScarce() && memory.isNearlyFull(clock.now()));
  }

  private void say(String text) {
    err.println("urbi: " + text);
  }

  private static double seconds(long nanoseconds) {
    return nanoseconds / 100_000_000 / 10.0;
  }
}
