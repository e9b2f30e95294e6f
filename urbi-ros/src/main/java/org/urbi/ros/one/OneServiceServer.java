package org.urbi.ros.one;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.Failures;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.TypeHash;

/** A service of this node. */
final class OneServiceServer implements ServiceServer {
  private final OneNode node;
  private final String service;
  private final ServiceType type;
  private final String md5;
  private final ServiceServer.Handler handler;
  private final MessageCodec requests;
  private final MessageCodec responses;
  private final Set<TcpRosConnection> clients = ConcurrentHashMap.newKeySet();
  private volatile boolean closed;

  OneServiceServer(OneNode node, String service, ServiceType type, ServiceServer.Handler handler) {
    this.node = node;
    this.service = service;
    this.type = type;
    this.md5 = TypeHash.md5(type);
    this.handler = handler;
    this.requests = MessageCodec.of(type.request());
    this.responses = MessageCodec.of(type.response());
  }

  @Override
  public String service() {
    return service;
  }

  @Override
  public ServiceType type() {
    return type;
  }

  /** Answers the requests of a client until it goes; only one if that is all that it asks for. */
  void serve(Map<String, String> header, TcpRosConnection connection)
      throws IOException, InterruptedException {
    String theirs = header.getOrDefault(ConnectionHeader.MD5, "");
    if (!theirs.equals(TypeHash.ANY_MD5) && !theirs.equals(md5)) {
      connection.sendHeader(
          Map.of(
              ConnectionHeader.ERROR,
              "request from ["
                  + header.getOrDefault(ConnectionHeader.CALLER, "?")
                  + "]: md5sums do not match: ["
                  + theirs
                  + "] vs. ["
                  + md5
                  + "]"));
      return;
    }
    connection.sendHeader(header());
    if ("1".equals(header.get(ConnectionHeader.PROBE))) {
      return;
    }
    clients.add(connection);
    try {
      if ("1".equals(header.get(ConnectionHeader.PERSISTENT))) {
        Threads.startPrompt("service", () -> answerAll(connection)).join();
      } else {
        answer(connection, connection.read());
      }
    } catch (EOFException e) {
      // The usual end.
      return;
    } finally {
      clients.remove(connection);
    }
  }

  private void answerAll(TcpRosConnection connection) throws IOException {
    while (!closed) {
      answer(connection, connection.read());
    }
  }

  private Map<String, String> header() {
    String name = type.name().in(Dialect.ROS_1);
    Map<String, String> header = new LinkedHashMap<>();
    header.put(ConnectionHeader.CALLER, node.name());
    header.put(ConnectionHeader.SERVICE, service);
    header.put(ConnectionHeader.TYPE, name);
    header.put(ConnectionHeader.MD5, md5);
    header.put("request_type", name + "Request");
    header.put("response_type", name + "Response");
    return header;
  }

  private void answer(TcpRosConnection connection, ByteBuffer request) throws IOException {
    byte[] answer;
    boolean done = false;
    try {
      answer =
          responses.encode(handler.answer(requests.decode(request)).toCompletableFuture().join());
      done = true;
    } catch (RuntimeException | Error e) {
      answer = Failures.told("the service " + service, e).getBytes(StandardCharsets.UTF_8);
    }
    connection.writeByte(done ? 1 : 0);
    connection.write(answer);
    connection.flush();
  }

  @Override
  public void close() {
    closed = true;
    node.remove(this);
    clients.forEach(TcpRosConnection::close);
  }
}
