package org.urbi.ros.bridge;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.net.AcceptLoop;
import urbi.thread.GuardedThreads;
import urbi.thread.InternalFailure;

/**
 * Listens for clients of rosbridge. The protocol of the WebSocket is here, and not of a library:
 * the module needs nothing but the JDK, wherever it runs.
 */
public final class BridgeServer implements AutoCloseable {
  /** How many clients there may be, and as many besides that have not finished their request. */
  private static final int MOST = 64;

  private static final int SHORTEST_TOKEN = 16;

  /** Milliseconds that a request may pause. */
  private static final int PATIENCE = 10_000;

  /** After a wrong token. */
  private static final Duration PAUSE = Duration.ofSeconds(1);

  private final Node node;
  private final ServerSocket server;
  private final Set<String> origins;
  private final String token;
  private final Consumer<String> people;
  private final Set<Socket> clients = ConcurrentHashMap.newKeySet();

  /** Clients that have not been let in yet, in the order in which they came. */
  private final Set<Socket> waiting = new LinkedHashSet<>();

  private BridgeServer(
      Node node, ServerSocket server, Set<String> origins, String token, Consumer<String> people) {
    this.node = node;
    this.server = server;
    this.origins = origins;
    this.token = token;
    this.people = people;
  }

  /**
   * Begins to listen.
   *
   * @param host the address of this machine; other machines reach any but the loopback ones
   * @param port 0 for any that is free
   * @param origins of which pages may connect besides those of this machine: {@code
   *     https://robot.example}
   * @param token what clients show; empty: they need not
   * @param people are told what is refused, by threads of the server
   * @throws RosException if that cannot be
   */
  public static BridgeServer open(
      Node node,
      String host,
      int port,
      Set<String> origins,
      String token,
      Consumer<String> people) {
    try {
      InetAddress address = InetAddress.getByName(host);
      if (token.isEmpty() && !address.isLoopbackAddress()) {
        throw new RosException(
            "whoever reaches " + host + " could do everything: set a token, or host to localhost");
      }
      if (!token.isEmpty() && token.length() < SHORTEST_TOKEN) {
        throw new RosException("token: " + SHORTEST_TOKEN + " characters at least expected");
      }
      ServerSocket socket = new ServerSocket();
      socket.setReuseAddress(true);
      socket.bind(new InetSocketAddress(address, port));
      BridgeServer made = new BridgeServer(node, socket, Set.copyOf(origins), token, people);
      AcceptLoop loop =
          new AcceptLoop("urbi-ros-bridge-in", socket, made.new Guests(), made::tell, PAUSE);
      GuardedThreads.SDK.platform("urbi-ros-bridge", loop).start();
      return made;
    } catch (IOException | IllegalArgumentException e) {
      throw new RosException("no bridge at " + host + ":" + port + ": " + e.getMessage(), e);
    }
  }

  public int port() {
    return server.getLocalPort();
  }

  /** How many clients are connected. */
  public int clients() {
    return clients.size();
  }

  private void tell(String what) {
    people.accept("rosbridge: " + what);
  }

  /** Whoever connects. */
  private final class Guests implements AcceptLoop.Clients {
    @Override
    public boolean arrives(Socket socket) {
      addWaiting(socket);
      return true;
    }

    @Override
    public void serve(Socket socket) throws IOException {
      serveGuest(socket);
    }

    @Override
    public void leaves(Socket socket) {
      synchronized (waiting) {
        waiting.remove(socket);
        clients.remove(socket);
      }
      if (server.isClosed()) {
        endAll();
      }
    }
  }

  /** Half a request makes room for the next one, so that a few lock out nobody. */
  private void addWaiting(Socket socket) {
    synchronized (waiting) {
      waiting.add(socket);
      if (waiting.size() > MOST) {
        Socket oldest = waiting.iterator().next();
        waiting.remove(oldest);
        end(oldest);
      }
    }
  }

  private static void pause() {
    try {
      Thread.sleep(PAUSE);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void serveGuest(Socket socket) throws IOException {
    try {
      socket.setTcpNoDelay(true);
      socket.setSoTimeout(PATIENCE);
      InputStream in = new BufferedInputStream(socket.getInputStream(), 1 << 16);
      OutputStream out = new BufferedOutputStream(socket.getOutputStream(), 1 << 16);
      if (isLetIn(in, out, socket)) {
        new BridgeClient(node, new WebSocket(socket, in, out)).run();
      }
    } catch (RuntimeException | Error e) {
      tell(InternalFailure.text(e));
      throw e;
    }
  }

  /** Counts it among the clients. */
  private void letIn(Socket socket) {
    synchronized (waiting) {
      if (clients.size() >= MOST) {
        throw new BridgeException("503 Service Unavailable");
      }
      waiting.remove(socket);
      clients.add(socket);
    }
  }

  private boolean isLetIn(InputStream in, OutputStream out, Socket socket) throws IOException {
    String answer;
    boolean good = false;
    try {
      Handshake request = Handshake.read(in);
      request.check(origins, token);
      letIn(socket);
      answer = request.accepted();
      good = true;
    } catch (BridgeException e) {
      String status = String.valueOf(e.getMessage());
      tell("refused " + socket.getInetAddress() + ": " + status);
      if (status.startsWith("401")) {
        pause();
      }
      answer = Handshake.refused(status);
    }
    out.write(answer.getBytes(StandardCharsets.ISO_8859_1));
    out.flush();
    return good;
  }

  private void endAll() {
    synchronized (waiting) {
      waiting.forEach(BridgeServer::end);
    }
    clients.forEach(BridgeServer::end);
  }

  private static void end(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      // It is closed, or will be.
    }
  }

  @Override
  public void close() {
    try {
      server.close();
    } catch (IOException e) {
      tell(String.valueOf(e.getMessage()));
    }
    endAll();
  }
}
