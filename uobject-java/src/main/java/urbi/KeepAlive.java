package urbi;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import urbi.time.Stopwatch;

/** Asks at intervals of silence, and gives up when the silence goes on. */
final class KeepAlive {
  private final long interval;
  private final long patience;
  private final Runnable ask;
  private final Runnable giveUp;
  private final Thread thread;
  private final Stopwatch silence = new Stopwatch();
  private final AtomicInteger signs = new AtomicInteger();

  /**
   * @param interval milliseconds of silence before asking
   * @param patience milliseconds for the answer
   */
  KeepAlive(long interval, long patience, Runnable ask, Runnable giveUp) {
    this.interval = interval;
    this.patience = patience;
    this.ask = ask;
    this.giveUp = giveUp;
    thread = Thread.ofVirtual().name("urbi-keep-alive").start(this::run);
  }

  /** There has been a sign of life. */
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
          Thread.sleep(patience);
          if (signs.get() == before) {
            giveUp.run();
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
