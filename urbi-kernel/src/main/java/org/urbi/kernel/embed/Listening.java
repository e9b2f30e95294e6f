package org.urbi.kernel.embed;

/** A subscription of Java code to something that happens in a kernel. */
@FunctionalInterface
public interface Listening extends AutoCloseable {
  /**
   * Listens no more; from any thread, any number of times. No call of the listener begins after
   * this returns; one that is going on may go on.
   */
  @Override
  void close();
}
