package org.urbi.server.cli;

import sun.misc.Signal;
import sun.misc.SignalHandler;

/**
 * Handles signals of the system. The JDK offers only {@code sun.misc.Signal} for this, and javac
 * warns of every use: therefore this file is compiled separately (see the pom).
 */
final class Signals {
  private Signals() {}

  /** Runs an action on a thread of the JVM at each SIGINT, instead of ending the process. */
  static void whenInterrupted(Runnable reaction) {
    Signal.handle(new Signal("INT"), signal -> reaction.run());
  }

  /** Runs an action at each SIGWINCH: the terminal has another size. */
  static void whenResized(Runnable reaction) {
    Signal.handle(new Signal("WINCH"), signal -> reaction.run());
  }

  /** Runs an action at each SIGCONT: the process goes on after it was stopped. */
  static void whenContinued(Runnable reaction) {
    Signal.handle(new Signal("CONT"), signal -> reaction.run());
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
