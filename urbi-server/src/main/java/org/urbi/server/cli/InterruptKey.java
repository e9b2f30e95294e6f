package org.urbi.server.cli;

import sun.misc.Signal;

/**
 * The signal of the interrupt key. The JDK has no other class that hears of it, and javac warns of
 * this one wherever it is named: that is why this file is compiled by itself (see the pom).
 */
final class InterruptKey {
  private InterruptKey() {}

  /** Runs {@code reaction} on a thread of the JVM each time the key is hit, instead of ending. */
  static void whenHit(Runnable reaction) {
    Signal.handle(new Signal("INT"), signal -> reaction.run());
  }
}
