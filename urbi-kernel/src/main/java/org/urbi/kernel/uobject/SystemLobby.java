package org.urbi.kernel.uobject;

import org.urbi.kernel.library.system.KernelControl;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Interpreter;

/**
 * The lobby of code that belongs to no connection, such as what UObjects send; made when it is
 * needed. What it sends goes to the log of the kernel.
 */
final class SystemLobby {
  private final Interpreter interpreter;
  private final KernelControl kernel;
  private UrbiLobby lobby;

  SystemLobby(Interpreter interpreter, KernelControl kernel) {
    this.interpreter = interpreter;
    this.kernel = kernel;
  }

  /** The lobby; on the kernel thread. */
  UrbiLobby get() {
    if (lobby == null) {
      Shell.Listener listener =
          new Shell.Listener() {
            @Override
            public void consumed() {}

            @Override
            public void finished() {
              lobby = null;
            }
          };
      lobby =
          UrbiLobby.start(interpreter, new Output(interpreter.scheduler(), this::log), listener);
      lobby.shell().start();
    }
    return lobby;
  }

  private void log(String bytes) {
    for (String line : Texts.toJava(bytes).split("\n")) {
      kernel.log(line);
    }
  }
}
