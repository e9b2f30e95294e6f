package org.urbi.kernel.uobject;

import java.nio.file.Path;
import org.urbi.kernel.node.Frame;
import urbi.UModuleException;

/** Runs modules in processes of their own. Used on the kernel thread. */
public interface ModuleIsolation {
  /** A module in a process of its own. */
  interface IsolatedModule {
    /**
     * Waits until the classes of the module can be used.
     *
     * @throws UModuleException if that fails; the message says why
     */
    void awaitStart();

    /** Whether its process has not ended. */
    boolean isRunning();

    /** Ends the process: its objects stay in urbiscript, without their functions. */
    void end();
  }

  /**
   * Starts the process, without waiting for it.
   *
   * @throws UModuleException if there are no such processes here
   */
  IsolatedModule start(Frame frame, Path file);
}
