package org.urbi.kernel.embed;

/**
 * The registration of a Java listener for something that happens in a kernel; closing it removes
 * the listener.
 */
@FunctionalInterface
public interface ListenerRegistration extends AutoCloseable {
  /**
   * Removes the listener. May be called from any thread, more than once. No call of the listener
   * starts after this returns; one that is in progress may continue.
   */
  @Override
  void close();
}
