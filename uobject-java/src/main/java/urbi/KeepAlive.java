package urbi;

/** Asks at intervals of silence, and gives up when the silence goes on. */
final class KeepAlive {
  private final long interval;
  private final long patience;
  private final Runnable ask;
  private final Runnable giveUp;
  private final Thread thread;
  private volatile long last = System.nanoTime();

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
    last = System.nanoTime();
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
          long asked = last;
          ask.run();
          Thread.sleep(patience);
          if (last == asked) {
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
    return milliseconds - (System.nanoTime() - last) / 1_000_000;
  }
}
