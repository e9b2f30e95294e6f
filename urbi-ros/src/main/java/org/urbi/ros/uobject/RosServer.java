package org.urbi.ros.uobject;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UEvent;
import urbi.UObject;

/**
 * A service that urbiscript offers: each request is an event, with a number under which it is
 * answered. {@code Ros.offer} in {@code ros.u} makes one of a function.
 */
public final class RosServer extends UObject implements AutoCloseable {
  static {
    UStart(RosServer.class);
  }

  /** So many wait for urbiscript at most; more are refused. */
  private static final int MOST = 1000;

  private final UEvent onRequest = new UEvent();
  private final Map<Integer, CompletableFuture<UDictionary>> asked = new ConcurrentHashMap<>();
  private final AtomicInteger count = new AtomicInteger();
  private volatile @Nullable ServiceServer server;
  private boolean closed;

  public RosServer(String name) {
    super(name);
    UBindEvent(onRequest, "onRequest");
    UBindFunctions("begin", "name", "resStruct", "answer", "refuse", "close");
  }

  /** Offers a service. The job waits until the others can know. */
  public CompletionStage<Void> begin(String name, String type) {
    return Ros.of(this)
        .thenCompose(node -> {
          ServiceType known = node.definitions().service(type);
          return node.prepared(known.request()).thenCompose(ready -> serve(node, name, known));
        });
  }

  private synchronized CompletionStage<Void> serve(Node node, String name, ServiceType type) {
    if (closed) {
      throw new RosException(name + " is not offered any more");
    }
    server = node.serve(name, type, this::ask);
    return node.settled();
  }

  private CompletionStage<UDictionary> ask(UDictionary request) {
    if (asked.size() >= MOST) {
      return CompletableFuture.failedFuture(
          new RosException("too many requests wait for an answer"));
    }
    CompletableFuture<UDictionary> answer = new CompletableFuture<>();
    int number = count.incrementAndGet();
    asked.put(number, answer);
    onRequest.emit(number, request);
    return answer;
  }

  private ServiceServer server() {
    ServiceServer known = server;
    if (known == null) {
      throw new RosException("no service is offered");
    }
    return known;
  }

  /** The full name of the service. */
  public String name() {
    return server().service();
  }

  /** A new response. */
  public UDictionary resStruct() {
    return Templates.of(server().type().response());
  }

  /** Answers a request. */
  public void answer(int number, UDictionary response) {
    CompletableFuture<UDictionary> waiting = asked.remove(number);
    if (waiting != null) {
      waiting.complete(response);
    }
  }

  /** Tells the one who has asked that it failed. */
  public void refuse(int number, String reason) {
    CompletableFuture<UDictionary> waiting = asked.remove(number);
    if (waiting != null) {
      waiting.completeExceptionally(new RosException(reason));
    }
  }

  /** Ends the service. */
  @Override
  public synchronized void close() {
    closed = true;
    ServiceServer known = server;
    server = null;
    if (known != null) {
      known.close();
    }
    asked.values().forEach(each -> each.completeExceptionally(new RosException("closed")));
    asked.clear();
  }
}
