package org.urbi.kernel;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.job.EndInPieces;
import org.urbi.kernel.lobby.Lobbies;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.outside.SocketConnection;
import org.urbi.kernel.trust.Role;

/** The lobbies of a kernel: one for each connection, and those created by programs. */
final class KernelLobbies implements Lobbies {
  private static final int SWEPT_FROM = 16;

  private final Kernel kernel;
  private final Set<UrbiLobby> created = new LinkedHashSet<>();

  /**
   * Those that have ended, while jobs of theirs may go on, which know them: nothing else is to keep
   * them. Swept now and then.
   */
  private final List<WeakReference<UrbiLobby>> ended = new ArrayList<>();

  private int sweptAt = SWEPT_FROM;

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

  /**
   * Ends those that share that budget, which is that of a client that has left, with all that they
   * have left behind.
   */
  void endAll(Budget budget) {
    end(created, budget, lobby -> lobby.endForGood(kernel.interpreter()));
    endLeft(budget);
  }

  /**
   * Ends what those do that share that budget, which is that of a client, and what those have left
   * behind that have ended.
   */
  void evictAll(Budget budget) {
    end(created, budget, lobby -> lobby.shell().evict(lobby.shell().lastStatement()));
    endLeft(budget);
  }

  private void endLeft(Budget budget) {
    List<UrbiLobby> left = ended.stream().flatMap(each -> Stream.ofNullable(each.get())).toList();
    end(left, budget, lobby -> lobby.endDetached(kernel.interpreter()));
  }

  private void end(Collection<UrbiLobby> all, Budget budget, Consumer<UrbiLobby> how) {
    EndInPieces.begin(
        kernel.scheduler(),
        all.stream().filter(lobby -> lobby.budget() == budget).toList(),
        lobby -> {
          how.accept(lobby);
          return List.of();
        });
  }

  private void gone(UrbiLobby lobby) {
    if (created.remove(lobby) && !kernel.isStopping()) {
      lobby.disconnected(kernel.interpreter(), this);
      ended.add(new WeakReference<>(lobby));
      if (ended.size() > sweptAt) {
        ended.removeIf(other -> isOver(other.get()));
        sweptAt = Math.max(SWEPT_FROM, 2 * ended.size());
      }
    }
  }

  private static boolean isOver(@Nullable UrbiLobby lobby) {
    return lobby == null || lobby.hasEnded() && !lobby.hasDetached();
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
