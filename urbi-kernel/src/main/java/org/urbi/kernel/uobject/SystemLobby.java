package org.urbi.kernel.uobject;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.trust.Role;

/**
 * The lobby of code that belongs to no connection, such as code sent by UObjects; created on first
 * use. Its output goes to the log of the kernel.
 */
final class SystemLobby {
  private final Interpreter interpreter;
  private final KernelLog log;
  private @Nullable UrbiLobby lobby;

  SystemLobby(Interpreter interpreter, KernelLog log) {
    this.interpreter = interpreter;
    this.log = log;
  }

  /** The lobby; on the kernel thread. */
  UrbiLobby get() {
    UrbiLobby known = lobby;
    if (known == null) {
      Shell.Listener listener =
          new Shell.Listener() {
            @Override
            public void consumed() {}

            @Override
            public void finished() {
              lobby = null;
            }
          };
      known =
          UrbiLobby.start(
              interpreter,
              new Output(interpreter.scheduler(), this::write),
              listener,
              Role.OWNER,
              new Budget());
      lobby = known;
      known.shell().start();
    }
    return known;
  }

  private void write(String bytes) {
    for (String line : Utf8Text.toJava(bytes).split("\n")) {
      log.write(line);
    }
  }
}
