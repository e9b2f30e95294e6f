package org.urbi.ros.net;

import java.io.IOException;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.function.Consumer;
import urbi.thread.GuardedThreads;
import urbi.thread.InternalFailure;

/**
 * Accepts connections until its socket is closed, and serves each on a thread of its own. Nothing
 * that one of them meets ends that: no defect, and no lack of memory, threads or files.
 */
public final class AcceptLoop implements Runnable {
  /** Decides what becomes of each connection. */
  public interface Clients {
    /** Whether a client that has just connected is to be served; on the thread that accepts. */
    boolean arrives(Socket client) throws IOException;

    /** Serves a client until one of both sides ends the connection; on a thread of its own. */
    void serve(Socket client) throws IOException;

    /** A client was refused, or its service has ended; nothing else is called for it. */
    void leaves(Socket client);
  }

  private final String name;
  private final ServerSocket server;
  private final Clients clients;
  private final Consumer<String> people;
  private final Duration pause;

  /**
   * @param name of the threads that serve
   * @param people are told why one is not served; on the thread that accepts
   * @param pause after that, which gives others the time to end
   */
  public AcceptLoop(
      String name, ServerSocket server, Clients clients, Consumer<String> people, Duration pause) {
    this.name = name;
    this.server = server;
    this.clients = clients;
    this.people = people;
    this.pause = pause;
  }

  @Override
  public void run() {
    while (!server.isClosed()) {
      try {
        take(server.accept());
      } catch (IOException e) {
        refused(String.valueOf(e.getMessage()));
      } catch (RuntimeException | Error e) {
        InternalFailure.log("accepting connections", e);
        refused(InternalFailure.text(e));
      }
    }
  }

  private void take(Socket client) throws IOException {
    boolean isServed = false;
    try {
      if (clients.arrives(client)) {
        GuardedThreads.SDK.virtual(name, () -> serve(client)).start();
        isServed = true;
      }
    } finally {
      if (!isServed) {
        end(client);
        clients.leaves(client);
      }
    }
  }

  private void serve(Socket client) {
    try (client) {
      clients.serve(client);
    } catch (IOException e) {
      // It has gone, or was let go: it knows.
    } finally {
      clients.leaves(client);
    }
  }

  private void refused(String reason) {
    if (server.isClosed()) {
      return;
    }
    try {
      people.accept("a connection is refused: " + reason);
      Thread.sleep(pause);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (RuntimeException | Error e) {
      InternalFailure.log("telling of a connection that is refused", e);
    }
  }

  private static void end(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      // It is closed, or will be.
    }
  }
}
