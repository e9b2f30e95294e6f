package org.urbi.server.cli;

import sun.misc.Signal;
import sun.misc.SignalHandler;

/**
 * Handles the signals SIGINT and SIGTERM. The JDK offers only {@code sun.misc.Signal} for this, and
 * javac warns of every use: therefore this file is compiled separately (see the pom).
 */
final class Signals {
  private Signals() {}

  /** Runs an action on a thread of the JVM at each SIGINT, instead of ending the process. */
  static void whenInterrupted(Runnable reaction) {
    Signal.handle(new Signal("INT"), signal -> reaction.run());
  }

  /** Restores the default: SIGTERM ends the process. */
  static void endWhenTerminated() {
    Signal.handle(new Signal("TERM"), SignalHandler.SIG_DFL);
  }

  /** Runs an action on a thread of the JVM at SIGTERM, instead of ending the process. */
  static void whenTerminated(Runnable reaction) {
    Signal.handle(new Signal("TERM"), signal -> reaction.run());
  }
}
