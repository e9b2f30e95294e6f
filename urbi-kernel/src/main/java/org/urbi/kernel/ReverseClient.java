package org.urbi.kernel;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.outside.SocketConnection;

/** A client that the kernel has called, and its lobby ({@code Lobby.reverseConnect}). */
final class ReverseClient implements Shell.Listener, SocketConnection.Listener {
  /** How many bytes of output may wait before a client that does not read is disconnected. */
  private static final int MOST_OUTPUT = 16 << 20;

  private final Interpreter interpreter;
  private final SocketConnection link;
  private final Consumer<UrbiLobby> gone;
  private final UrbiLobby lobby;
  private final ArrayDeque<String> waiting = new ArrayDeque<>();
  private @Nullable Job writer;
  private boolean writing;
  private boolean over;
  private long unsent;
  private long unread;

  /**
   * @param creator the lobby that asked for the connection; the client has its role and budget
   * @param gone told when it is over
   */
  ReverseClient(
      Interpreter interpreter,
      UrbiLobby creator,
      SocketConnection link,
      String address,
      Consumer<UrbiLobby> gone) {
    this.interpreter = interpreter;
    this.link = link;
    this.gone = gone;
    Output output = new Output(interpreter.scheduler(), this::show);
    lobby = UrbiLobby.start(interpreter, output, this, creator.role(), creator.budget());
    lobby.setRemoteAddress(address);
  }

  UrbiLobby lobby() {
    return lobby;
  }

  void open() {
    writer =
        interpreter
            .scheduler()
            .startDetached(lobby, interpreter.scheduler().rootScope(), "output", this::write);
    lobby.shell().start();
    link.open(this);
  }

  // ------------------------------------------------------------------ in

  @Override
  public void received(byte[] bytes) {
    if (over) {
      link.consumed(bytes.length);
    } else {
      unread += bytes.length;
      lobby.shell().receive(new String(bytes, StandardCharsets.ISO_8859_1));
    }
  }

  @Override
  public void consumed() {
    int read = (int) (unread - lobby.shell().pending());
    if (read > 0) {
      unread -= read;
      link.consumed(read);
    }
  }

  @Override
  public void ended(@Nullable String error) {
    finished();
  }

  // ------------------------------------------------------------------ out

  private void show(String bytes) {
    unsent += bytes.length();
    waiting.add(bytes);
    if (unsent > MOST_OUTPUT) {
      finished();
    } else if (writing && writer != null) {
      writing = false;
      writer.wake();
    }
  }

  private void write(Job self) {
    try {
      while (!over || !waiting.isEmpty()) {
        String bytes = waiting.poll();
        if (bytes == null) {
          writing = true;
          self.setDaemon(true);
          self.waitForWake();
          self.setDaemon(false);
        } else {
          unsent -= bytes.length();
          link.write(self, bytes.getBytes(StandardCharsets.ISO_8859_1));
        }
      }
      link.close();
    } catch (IOException e) {
      finished();
    }
  }

  // ------------------------------------------------------------------ the end

  @Override
  public void finished() {
    if (over) {
      return;
    }
    over = true;
    lobby.shell().close();
    lobby.output().close();
    gone.accept(lobby);
    if (writing && writer != null) {
      writing = false;
      writer.wake();
    }
  }
}
