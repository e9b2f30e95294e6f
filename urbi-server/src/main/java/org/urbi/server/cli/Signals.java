package org.urbi.server.cli;

import sun.misc.Signal;
import sun.misc.SignalHandler;

/**
 * The signals of the interrupt key and of who wants the process to terminate. The JDK has no other
 * class that hears of them, and javac warns of this one wherever it is named: that is why this file
 * is compiled by itself (see the pom).
 */
final class Signals {
  private Signals() {}

  /**
   * Runs something on a thread of the JVM each time the interrupt key is hit, instead of ending.
   */
  static void whenInterrupted(Runnable reaction) {
    Signal.handle(new Signal("INT"), signal -> reaction.run());
  }

  /** Has the system end the process when it is to terminate, as if nobody listened. */
  static void endWhenTerminated() {
    Signal.handle(new Signal("TERM"), SignalHandler.SIG_DFL);
  }

  /** Runs something on a thread of the JVM when the process is to terminate, instead of ending. */
  static void whenTerminated(Runnable reaction) {
    Signal.handle(new Signal("TERM"), signal -> reaction.run());
  }
}
