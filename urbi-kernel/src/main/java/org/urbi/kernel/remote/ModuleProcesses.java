package org.urbi.kernel.remote;

import java.nio.file.Path;

/** Makes the processes of isolated modules: the program around the kernel provides it. */
public interface ModuleProcesses {
  /**
   * Prepares a process, which is not started yet.
   *
   * @param file the module that it loads
   * @param peer the kernel's side, which is told of the connection and of the end
   */
  ModuleProcess process(Path file, RemotePeer peer);
}
