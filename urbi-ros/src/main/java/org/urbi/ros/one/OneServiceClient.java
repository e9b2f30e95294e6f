package org.urbi.ros.one;

import java.io.IOException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.codec.CodecException;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.TypeHash;
import urbi.UDictionary;

/** Calls a service: by a connection for each request, or by one that is kept. */
final class OneServiceClient implements ServiceClient {
  private final OneNode node;
  private final String service;
  private final ServiceType type;
  private final boolean keepAlive;
  private final MessageCodec requests;
  private final MessageCodec responses;
  private final Set<TcpRosConnection> open = ConcurrentHashMap.newKeySet();
  private final Executor turns;

  /** Only who has the turn looks at it. */
  private @Nullable TcpRosConnection kept;

  private volatile boolean closed;

  OneServiceClient(OneNode node, String service, ServiceType type, boolean keepAlive) {
    this.node = node;
    this.service = service;
    this.type = type;
    this.keepAlive = keepAlive;
    this.requests = MessageCodec.of(type.request());
    this.responses = MessageCodec.of(type.response());
    this.turns = keepAlive ? Threads.inTurn("service-client") : Threads.POOL;
  }

  /** What a service says of itself: its type, its MD5 sum. */
  static Map<String, String> probe(OneNode node, String service, URI address) throws IOException {
    try (TcpRosConnection connection = TcpRosConnection.to(address.getHost(), address.getPort())) {
      Map<String, String> header = header(node, service, TypeHash.ANY_MD5);
      header.put(ConnectionHeader.PROBE, "1");
      connection.sendHeader(header);
      return checked(connection.readHeader());
    }
  }

  private static Map<String, String> header(OneNode node, String service, String md5) {
    Map<String, String> header = new LinkedHashMap<>();
    header.put(ConnectionHeader.CALLER, node.name());
    header.put(ConnectionHeader.SERVICE, service);
    header.put(ConnectionHeader.MD5, md5);
    return header;
  }

  private static Map<String, String> checked(Map<String, String> header) {
    String error = header.get(ConnectionHeader.ERROR);
    if (error != null) {
      throw new RosException(error);
    }
    return header;
  }

  @Override
  public String service() {
    return service;
  }

  @Override
  public ServiceType type() {
    return type;
  }

  @Override
  public CompletableFuture<UDictionary> request(UDictionary request) {
    byte[] bytes = requests.encode(request);
    CompletableFuture<UDictionary> answer = new CompletableFuture<>();
    turns.execute(() -> {
      try {
        answer.complete(keepAlive ? askKept(bytes, answer) : askOnce(bytes, answer));
      } catch (IOException e) {
        answer.completeExceptionally(
            new RosException(closed ? service + ": closed" : service + ": " + e.getMessage(), e));
      } catch (CodecException e) {
        answer.completeExceptionally(new RosException(service + ": " + e.getMessage(), e));
      } catch (RuntimeException | Error e) {
        answer.completeExceptionally(e);
      }
    });
    return answer;
  }

  private UDictionary askOnce(byte[] request, CompletableFuture<?> answer) throws IOException {
    TcpRosConnection connection = connect();
    try {
      return ask(connection, request, answer);
    } finally {
      end(connection);
    }
  }

  /** One after the other, by a connection that is made again when the service has closed it. */
  private UDictionary askKept(byte[] request, CompletableFuture<?> answer) throws IOException {
    if (answer.isDone()) {
      throw new IOException("nobody waits for the answer any more");
    }
    TcpRosConnection connection = kept;
    if (connection != null && connection.isOver()) {
      end(connection);
      connection = null;
    }
    if (connection == null) {
      kept = null;
      connection = connect();
      kept = connection;
    }
    try {
      return ask(connection, request, answer);
    } catch (IOException e) {
      // The service may have done it already: only who has asked can know whether to ask again.
      end(connection);
      kept = null;
      throw e;
    }
  }

  private TcpRosConnection connect() throws IOException {
    URI address = node.serviceAddress(service);
    TcpRosConnection connection = TcpRosConnection.watched(address.getHost(), address.getPort());
    open.add(connection);
    try {
      if (closed) {
        throw new IOException("closed");
      }
      Map<String, String> header = header(node, service, TypeHash.md5(type));
      header.put(ConnectionHeader.TYPE, type.name().in(Dialect.ROS_1));
      header.put(ConnectionHeader.NO_DELAY, "1");
      if (keepAlive) {
        header.put(ConnectionHeader.PERSISTENT, "1");
      }
      connection.sendHeader(header);
      checked(connection.readHeader());
      return connection;
    } catch (IOException | RuntimeException e) {
      end(connection);
      throw e;
    }
  }

  private void end(TcpRosConnection connection) {
    open.remove(connection);
    connection.close();
  }

  private UDictionary ask(TcpRosConnection connection, byte[] request, CompletableFuture<?> answer)
      throws IOException {
    answer.whenComplete((value, failure) -> {
      if (failure instanceof TimeoutException || failure instanceof CancellationException) {
        // What comes now would be taken for the answer to the next request.
        end(connection);
      }
    });
    connection.write(request);
    connection.flush();
    boolean done = connection.readByte() == 1;
    ByteBuffer response = connection.read();
    if (!done) {
      throw new RosException(service + ": " + StandardCharsets.UTF_8.decode(response));
    }
    return responses.decode(response);
  }

  @Override
  public void close() {
    closed = true;
    node.remove(this);
    open.forEach(TcpRosConnection::close);
  }
}
