package org.urbi.kernel;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import org.urbi.kernel.lobby.Completion;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.object.UrbiObject;

/** A connection: its methods post to the inbox, the rest runs on the kernel thread. */
final class KernelConnection implements Connection, Shell.Listener {
  private final Kernel kernel;
  private final Client client;
  private final boolean holdsTime;
  private final AtomicInteger pending = new AtomicInteger();
  private volatile boolean incomplete;
  private volatile UrbiLobby lobby;
  private boolean holding;
  private boolean ended;
  private boolean finished;

  KernelConnection(Kernel kernel, Client client, boolean holdsTime) {
    this.kernel = kernel;
    this.client = client;
    this.holdsTime = holdsTime;
  }

  // ------------------------------------------------------------------ from any thread

  @Override
  public void send(String bytes) {
    pending.addAndGet(bytes.length());
    kernel
        .inbox()
        .post(() -> {
          if (finished) {
            pending.set(0);
          } else {
            lobby.shell().receive(bytes);
          }
        });
  }

  @Override
  public void end() {
    kernel
        .inbox()
        .post(() -> {
          ended = true;
          releaseTime();
          if (!finished) {
            lobby.shell().end();
          }
        });
  }

  @Override
  public void close() {
    interruptRunning();
    kernel.inbox().post(this::finish);
  }

  @Override
  public void interrupt() {
    interruptRunning();
    kernel
        .inbox()
        .post(() -> {
          if (!finished) {
            lobby.shell().interrupt();
            consumed();
          }
        });
  }

  /** Code that never lets others run cannot wait for the inbox. */
  private void interruptRunning() {
    UrbiObject of = lobby;
    if (of != null) {
      kernel.scheduler().interrupt(of);
    }
  }

  @Override
  public int pendingInput() {
    return pending.get();
  }

  @Override
  public boolean incomplete() {
    return incomplete;
  }

  @Override
  public CompletableFuture<List<String>> complete(String text) {
    CompletableFuture<List<String>> names = new CompletableFuture<>();
    kernel.inbox().post(() -> names.complete(finished ? List.of() : Completion.of(lobby, text)));
    return names;
  }

  // ------------------------------------------------------------------ on the kernel thread

  void open() {
    if (kernel.isStopping()) {
      finished = true;
      client.closed();
      return;
    }
    Output output = new Output(kernel.scheduler(), client::output);
    UrbiLobby made = UrbiLobby.start(kernel.interpreter(), output, this);
    made.setRemoteAddress(client.remoteAddress());
    lobby = made;
    kernel.add(this);
    made.shell().start();
  }

  /** Its lobby; null before it is open. */
  UrbiLobby lobby() {
    return lobby;
  }

  /** A simulated time stands still while the shell waits for input that is to come now. */
  @Override
  public void starving(boolean begins) {
    if (begins && holdsTime && !ended) {
      holding = true;
      kernel.scheduler().holdTime();
    } else {
      releaseTime();
    }
  }

  private void releaseTime() {
    if (holding) {
      holding = false;
      kernel.scheduler().releaseTime();
    }
  }

  @Override
  public void consumed() {
    pending.set(lobby.shell().pending());
    incomplete = lobby.shell().isIncomplete();
    client.inputConsumed();
  }

  @Override
  public void finished() {
    finish();
  }

  /** The end, whoever brought it about. */
  void finish() {
    if (!finished) {
      finished = true;
      releaseTime();
      kernel.remove(this);
      pending.set(0);
      if (lobby != null) {
        lobby.shell().close();
        lobby.output().close();
        if (!kernel.isStopping()) {
          lobby.disconnected(kernel.interpreter());
        }
      }
      client.closed();
    }
  }
}
