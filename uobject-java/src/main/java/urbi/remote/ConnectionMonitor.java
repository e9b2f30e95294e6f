package urbi.remote;

import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import urbi.thread.GuardedThreads;
import urbi.time.Stopwatch;
import urbi.wire.Protocol;

/** Monitors a connection: notices when the other side is silent for too long. */
final class ConnectionMonitor implements AutoCloseable {
  private final Stopwatch silence;
  private final Runnable everySecond;
  private final Runnable ask;
  private final Runnable onTimeout;
  private final Thread thread;

  /**
   * @param silence the time since something was last received
   * @param everySecond is called once a second
   * @param ask sends a request that the other side answers
   * @param onTimeout is called once
   * @param onFailure is told when it ends because of a defect: nobody would notice silence
   */
  ConnectionMonitor(
      Stopwatch silence,
      Runnable everySecond,
      Runnable ask,
      Runnable onTimeout,
      Consumer<Throwable> onFailure) {
    this.silence = silence;
    this.everySecond = everySecond;
    this.ask = ask;
    this.onTimeout = onTimeout;
    // A virtual thread that writes would have the socket ask the system more often from then on.
    thread = GuardedThreads.SDK.platform("urbi-remote-keep-alive", this::watch, onFailure);
  }

  void start() {
    thread.start();
  }

  private void watch() {
    try {
      do {
        TimeUnit.SECONDS.sleep(1);
      } while (checkOnce());
    } catch (InterruptedException e) {
      // The connection has ended otherwise.
    }
  }

  /** Called once a second; returns whether to continue. */
  boolean checkOnce() {
    long seconds = silence.elapsed(TimeUnit.SECONDS);
    if (seconds >= Protocol.TIMEOUT_SECONDS) {
      onTimeout.run();
      return false;
    }
    everySecond.run();
    if (seconds >= Protocol.SILENCE_SECONDS) {
      ask.run();
    }
    return true;
  }

  /** Something has been received. */
  void alive() {
    silence.restart();
  }

  @Override
  public void close() {
    thread.interrupt();
  }
}
