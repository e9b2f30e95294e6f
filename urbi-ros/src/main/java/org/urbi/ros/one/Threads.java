package org.urbi.ros.one;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.Executor;
import urbi.thread.GuardedThreads;

/**
 * The threads of a node: each waits for one peer, and none keeps the program from ending. Those
 * that wait for an answer to each message are the system's, all others the JDK's.
 */
final class Threads {
  /** For how long a thread without work is kept. */
  private static final Duration IDLE = Duration.ofSeconds(10);

  /** Where what has come is worked on. */
  static final Executor POOL = GuardedThreads.SDK.virtualThreads("urbi-ros-task");

  private Threads() {}

  /** Work that waits for a peer again and again, one after the other: see {@link #startPrompt}. */
  static Executor inTurn(String name) {
    return GuardedThreads.SDK.inTurn("urbi-ros-" + name, IDLE);
  }

  /** What a thread does until its connection ends. */
  interface Work {
    void run() throws IOException, InterruptedException;
  }

  /** Starts a thread that ends with its connection: its owner notices that by itself. */
  static Thread start(String name, Work work) {
    return started(GuardedThreads.SDK.virtual("urbi-ros-" + name, body(work)));
  }

  /**
   * The same as {@link #start}, for a peer that waits for every answer: the system wakes such a
   * thread itself; before one of the others goes on, it wakes one or two more of the JDK.
   */
  static Thread startPrompt(String name, Work work) {
    return started(GuardedThreads.SDK.platform("urbi-ros-" + name, body(work)));
  }

  private static Runnable body(Work work) {
    return () -> {
      try {
        work.run();
      } catch (IOException | InterruptedException e) {
        // The peer has gone, or we have: whoever waits is told by what ends the connection.
        Thread.currentThread().interrupt();
      }
    };
  }

  private static Thread started(Thread thread) {
    thread.start();
    return thread;
  }
}
