package urbi.remote;

import java.util.concurrent.TimeUnit;
import urbi.time.Stopwatch;
import urbi.wire.Protocol;

/** Looks after a connection: notices when the other side is silent for too long. */
final class ConnectionMonitor implements AutoCloseable {
  private final Stopwatch silence;
  private final Runnable look;
  private final Runnable ask;
  private final Runnable giveUp;
  private final Thread thread;

  /**
   * @param silence since the last sign of life
   * @param look is called once a second
   * @param ask asks for a sign of life
   * @param giveUp is called once
   */
  ConnectionMonitor(Stopwatch silence, Runnable look, Runnable ask, Runnable giveUp) {
    this.silence = silence;
    this.look = look;
    this.ask = ask;
    this.giveUp = giveUp;
    // A virtual thread that writes would have the socket ask the system more often from then on.
    thread = Thread.ofPlatform().daemon().name("urbi-remote-keep-alive").unstarted(this::watch);
  }

  void start() {
    thread.start();
  }

  private void watch() {
    try {
      do {
        TimeUnit.SECONDS.sleep(1);
      } while (goesOn());
    } catch (InterruptedException | RuntimeException e) {
      // The connection has ended otherwise.
    }
  }

  /** To be called once a second; whether there is still something to look after. */
  boolean goesOn() {
    long seconds = silence.elapsed(TimeUnit.SECONDS);
    if (seconds >= Protocol.TIMEOUT_SECONDS) {
      giveUp.run();
      return false;
    }
    look.run();
    if (seconds >= Protocol.SILENCE_SECONDS) {
      ask.run();
    }
    return true;
  }

  /** There has been a sign of life. */
  void alive() {
    silence.restart();
  }

  @Override
  public void close() {
    thread.interrupt();
  }
}
