package urbi.remote;

import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import urbi.time.Stopwatch;

/** Remembers which function is being executed, and reports one that does not return for long. */
final class SlowCallMonitor {
  private static final long LONG_SECONDS = 10;

  private final Consumer<String> told;
  private volatile @Nullable String function;
  private final Stopwatch since = new Stopwatch();
  private boolean said;
  private volatile boolean paused;

  SlowCallMonitor(Consumer<String> told) {
    this.told = told;
  }

  void begin(String name) {
    since.restart();
    function = name;
  }

  /** The function waits for the kernel: that is not its fault. */
  void pause() {
    paused = true;
  }

  /** The function goes on. */
  void resume() {
    since.restart();
    paused = false;
  }

  /** The function that has been executed for longer than that without waiting, or null. */
  @Nullable String longerThan(long nanoseconds) {
    String name = function;
    return !paused && since.elapsed(TimeUnit.NANOSECONDS) > nanoseconds ? name : null;
  }

  void end() {
    function = null;
  }

  /** Reports, once, a function that has been executed for too long. Called by one thread. */
  void complain() {
    String name = function;
    boolean isLong = name != null && since.elapsed(TimeUnit.SECONDS) >= LONG_SECONDS;
    if (isLong && !said) {
      told.accept(
          name + " has not returned for " + LONG_SECONDS + " s; calls that are not threaded wait");
    }
    said = isLong;
  }
}
