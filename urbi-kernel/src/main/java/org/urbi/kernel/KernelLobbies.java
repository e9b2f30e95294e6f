package org.urbi.kernel;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.lobby.Lobbies;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.outside.SocketConnection;
import org.urbi.kernel.trust.Role;

/** The lobbies of a kernel: one for each connection, and those created by programs. */
final class KernelLobbies implements Lobbies {
  private final Kernel kernel;
  private final Set<UrbiLobby> created = new LinkedHashSet<>();

  KernelLobbies(Kernel kernel) {
    this.kernel = kernel;
  }

  @Override
  public List<UrbiLobby> all() {
    List<UrbiLobby> all = new ArrayList<>();
    for (KernelConnection connection : kernel.connections().all()) {
      all.add(connection.lobby());
    }
    all.addAll(created);
    return all;
  }

  @Override
  public UrbiLobby create(UrbiLobby creator) {
    UrbiLobby[] made = new UrbiLobby[1];
    Shell.Listener listener =
        new Shell.Listener() {
          @Override
          public void consumed() {}

          @Override
          public void finished() {
            creator.removeCreated(made[0]);
            gone(made[0]);
          }
        };
    made[0] =
        UrbiLobby.start(
            kernel.interpreter(),
            creator.output().branch(),
            listener,
            creator.role(),
            creator.budget());
    created.add(made[0]);
    if (creator.role() != Role.OWNER) {
      // It shares the budget of its creator, and must not live on beyond it.
      creator.addCreated(made[0]);
    }
    made[0].shell().start();
    return made[0];
  }

  /** Closes those that share that budget, which is that of a client. */
  void closeCreated(Budget budget) {
    UrbiLobby.closeAll(
        kernel.scheduler(), created.stream().filter(lobby -> lobby.budget() == budget).toList());
  }

  private void gone(UrbiLobby lobby) {
    if (created.remove(lobby) && !kernel.isStopping()) {
      lobby.disconnected(kernel.interpreter());
    }
  }

  @Override
  public UrbiLobby call(UrbiLobby caller, SocketConnection link, String address) {
    ReverseClient client =
        new ReverseClient(kernel.interpreter(), caller, link, address, this::gone);
    created.add(client.lobby());
    client.open();
    return client.lobby();
  }

  @Override
  public UrbiLobby system() {
    return kernel.uobjects().lobby();
  }
}
