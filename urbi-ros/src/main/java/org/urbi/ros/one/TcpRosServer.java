package org.urbi.ros.one;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Where other nodes connect to the topics and services of this one. */
final class TcpRosServer implements AutoCloseable {
  private static final int MAX_CONNECTIONS = 1024;

  private final ServerSocket socket;
  private final OneNode node;
  private final Set<Socket> peers = ConcurrentHashMap.newKeySet();

  TcpRosServer(InetAddress address, OneNode node) throws IOException {
    this.node = node;
    socket = new ServerSocket(0, 50, address);
  }

  void start() {
    Threads.start("connections", this::accept);
  }

  int port() {
    return socket.getLocalPort();
  }

  private void accept() throws IOException {
    while (!socket.isClosed()) {
      Socket peer = socket.accept();
      if (peers.size() >= MAX_CONNECTIONS) {
        peer.close();
        continue;
      }
      peers.add(peer);
      Threads.start(
          "connection",
          () -> {
            try (TcpRosConnection connection = new TcpRosConnection(peer)) {
              serve(connection);
            } finally {
              peers.remove(peer);
            }
          });
    }
  }

  private void serve(TcpRosConnection connection) throws IOException {
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
