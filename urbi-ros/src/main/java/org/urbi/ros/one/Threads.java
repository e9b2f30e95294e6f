package org.urbi.ros.one;

import java.io.IOException;
import java.util.concurrent.Executor;
import urbi.thread.GuardedThreads;

/** The threads of a node: each waits for one peer, and none keeps the program from ending. */
final class Threads {
  /** Where what has come is worked on. */
  static final Executor POOL = GuardedThreads.SDK.virtualThreads("urbi-ros-task");

  private Threads() {}

  /** What a thread does until its connection ends. */
  interface Work {
    void run() throws IOException, InterruptedException;
  }

  /** Starts a thread that ends with its connection: its owner notices that by itself. */
  static Thread start(String name, Work work) {
    Runnable body =
        () -> {
          try {
            work.run();
          } catch (IOException | InterruptedException e) {
            // The peer has gone, or we have: whoever waits is told by what ends the connection.
            Thread.currentThread().interrupt();
          }
        };
    Thread thread = GuardedThreads.SDK.virtual("urbi-ros-" + name, body);
    thread.start();
    return thread;
  }
}
