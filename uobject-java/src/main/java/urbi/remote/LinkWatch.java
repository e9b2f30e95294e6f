package urbi.remote;

import java.util.concurrent.TimeUnit;
import urbi.time.Stopwatch;
import urbi.wire.Protocol;

/** Looks after a connection: notices when the other side is silent for too long. */
final class LinkWatch implements AutoCloseable {
  private final Thread thread;
  private final Stopwatch silence = new Stopwatch();

  /**
   * @param look is called once a second
   * @param ask asks for a sign of life
   * @param giveUp is called once
   */
  LinkWatch(Runnable look, Runnable ask, Runnable giveUp) {
    thread =
        // A virtual thread that writes would have the socket ask the system more often from then
        // on.
        Thread.ofPlatform()
            .daemon()
            .name("urbi-remote-keep-alive")
            .start(() -> {
              try {
                while (silence() < Protocol.PATIENCE_SECONDS) {
                  TimeUnit.SECONDS.sleep(1);
                  look.run();
                  if (silence() >= Protocol.SILENCE_SECONDS) {
                    ask.run();
                  }
                }
                giveUp.run();
              } catch (InterruptedException | RuntimeException e) {
                // The connection has ended otherwise.
              }
            });
  }

  private long silence() {
    return silence.elapsed(TimeUnit.SECONDS);
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
