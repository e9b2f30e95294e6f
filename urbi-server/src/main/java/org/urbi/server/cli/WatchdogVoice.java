package org.urbi.server.cli;

import java.io.PrintStream;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Says what the watchdog has to say, on a thread of its own: the stream may be a pipe that nobody
 * reads, which has blocked the very threads that are watched.
 */
final class WatchdogVoice {
  private static final int MAX_WAITING = 16;

  private final PrintStream out;
  private final BlockingQueue<String> waiting = new ArrayBlockingQueue<>(MAX_WAITING);
  private final AtomicInteger unsaid = new AtomicInteger();
  private final Thread thread =
      Thread.ofPlatform().daemon().name("urbi-watchdog-voice").unstarted(this::speak);

  WatchdogVoice(PrintStream out) {
    this.out = out;
  }

  void start() {
    thread.start();
  }

  void stop() {
    thread.interrupt();
  }

  /** Has a text said, if the stream takes it. */
  void say(String text) {
    if (waiting.offer(text)) {
      unsaid.incrementAndGet();
    }
  }

  /** Waits until all has been said, so long at most. */
  void await(long milliseconds) throws InterruptedException {
    for (long i = 0; i < milliseconds && unsaid.get() > 0; i++) {
      Thread.sleep(1);
    }
  }

  private void speak() {
    try {
      while (true) {
        out.println("urbi: " + waiting.take());
        unsaid.decrementAndGet();
      }
    } catch (InterruptedException e) {
      // Stopped.
    }
  }
}
