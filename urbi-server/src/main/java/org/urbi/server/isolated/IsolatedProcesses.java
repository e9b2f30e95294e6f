package org.urbi.server.isolated;

import java.nio.file.Path;
import java.time.Duration;
import java.util.function.Consumer;
import org.urbi.kernel.remote.ModuleProcess;
import org.urbi.kernel.remote.ModuleProcesses;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.server.Trace;
import org.urbi.server.net.ModuleNetwork;

/** The processes of the modules of one server. */
public final class IsolatedProcesses implements ModuleProcesses, AutoCloseable {
  /** How long a process may take to start its module, on a busy machine. */
  public static final Duration START_LIMIT = Duration.ofSeconds(60);

  private final Duration startLimit;
  private final Duration maxHold;
  private final Trace trace;
  private final ModuleNetwork network;
  private final Consumer<Thread> begin;

  /**
   * @param startLimit how long a process may take to start its module
   * @param maxHold how long code of a module may hold up the rest of it; zero for any time
   */
  public IsolatedProcesses(Duration startLimit, Duration maxHold, Trace trace) {
    this(startLimit, maxHold, trace, Thread::start);
  }

  /**
   * @param begin starts the threads that attend to a process, or throws if there are none
   */
  IsolatedProcesses(Duration startLimit, Duration maxHold, Trace trace, Consumer<Thread> begin) {
    this.begin = begin;
    this.startLimit = startLimit;
    this.maxHold = maxHold;
    this.trace = trace;
    network = new ModuleNetwork(trace);
  }

  @Override
  public ModuleProcess process(Path file, RemotePeer peer) {
    return new IsolatedProcess(file, peer, network, startLimit, maxHold, trace, begin);
  }

  @Override
  public void close() {
    network.close();
  }
}
