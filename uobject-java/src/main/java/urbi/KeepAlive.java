package urbi;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import urbi.thread.GuardedThreads;
import urbi.time.Stopwatch;

/** Sends a request when the other side has been silent, and gives up when no answer comes. */
final class KeepAlive {
  private final long interval;
  private final long timeout;
  private final Runnable ask;
  private final Runnable onTimeout;
  private final Thread thread;
  private final Stopwatch silence = new Stopwatch();
  private final AtomicInteger signs = new AtomicInteger();

  /**
   * @param interval milliseconds of silence before a request
   * @param timeout milliseconds to wait for the answer
   * @param onFailure is told when it ends because of a defect: nobody would notice a timeout
   */
  KeepAlive(
      long interval,
      long timeout,
      Runnable ask,
      Runnable onTimeout,
      Consumer<Throwable> onFailure) {
    this.interval = interval;
    this.timeout = timeout;
    this.ask = ask;
    this.onTimeout = onTimeout;
    thread = GuardedThreads.SDK.virtual("urbi-keep-alive", this::run, onFailure);
    thread.start();
  }

  /** Something has been received. */
  void alive() {
    silence.restart();
    signs.incrementAndGet();
  }

  void stop() {
    thread.interrupt();
  }

  private void run() {
    try {
      while (true) {
        long left = left(interval);
        if (left > 0) {
          Thread.sleep(left);
        } else {
          int before = signs.get();
          ask.run();
          Thread.sleep(timeout);
          if (signs.get() == before) {
            onTimeout.run();
            return;
          }
        }
      }
    } catch (InterruptedException e) {
      // Stopped.
    }
  }

  private long left(long milliseconds) {
    return milliseconds - silence.elapsed(TimeUnit.MILLISECONDS);
  }
}
