package org.urbi.kernel.remote;

/**
 * A process for a module. Once it was started, {@link RemotePeer#ended} tells of its end, and of
 * one that does not start its module in time.
 */
public interface ModuleProcess {
  /** Starts it; this may wait for the machine. */
  void start();

  /** The classes of its module can be used. */
  void started();

  /** Ends it, without waiting; from any thread, even before the start. */
  void kill(String why);

  /** The connection to it is lost, so it ends, by itself or soon by force; from any thread. */
  void disconnected(String why);
}
