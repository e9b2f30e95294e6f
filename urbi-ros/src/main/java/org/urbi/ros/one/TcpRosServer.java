package org.urbi.ros.one;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.urbi.ros.net.AcceptLoop;
import urbi.Log;

/** Where other nodes connect to the topics and services of this one. */
final class TcpRosServer implements AutoCloseable {
  private static final int MAX_CONNECTIONS = 1024;

  /** After somebody could not be served. */
  private static final Duration PAUSE = Duration.ofSeconds(1);

  private final ServerSocket socket;
  private final OneNode node;
  private final Set<Socket> peers = ConcurrentHashMap.newKeySet();

  TcpRosServer(InetAddress address, OneNode node) throws IOException {
    this.node = node;
    socket = new ServerSocket(0, 50, address);
  }

  void start() {
    AcceptLoop loop = new AcceptLoop("urbi-ros-connection", socket, new Peers(), Log::error, PAUSE);
    Threads.start("connections", loop::run);
  }

  int port() {
    return socket.getLocalPort();
  }

  private final class Peers implements AcceptLoop.Clients {
    @Override
    public boolean arrives(Socket peer) {
      return peers.size() < MAX_CONNECTIONS && peers.add(peer);
    }

    @Override
    public void serve(Socket peer) throws IOException {
      try (TcpRosConnection connection = new TcpRosConnection(peer)) {
        servePeer(connection);
      } catch (InterruptedException e) {
        // The node ends.
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public void leaves(Socket peer) {
      peers.remove(peer);
    }
  }

  private void servePeer(TcpRosConnection connection) throws IOException, InterruptedException {
    Map<String, String> header = connection.readHeader();
    String topic = header.get(ConnectionHeader.TOPIC);
    String service = header.get(ConnectionHeader.SERVICE);
    Publication publication = topic == null ? null : node.publication(topic);
    OneServiceServer server = service == null ? null : node.server(service);
    if (publication != null) {
      publication.serve(header, connection);
    } else if (server != null) {
      server.serve(header, connection);
    } else {
      connection.sendHeader(
          Map.of(
              ConnectionHeader.ERROR,
              node.name() + " has neither topic " + topic + " nor service " + service));
    }
  }

  @Override
  public void close() throws IOException {
    socket.close();
    for (Socket peer : peers) {
      peer.close();
    }
  }
}
