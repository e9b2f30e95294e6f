package org.urbi.ros.bridge;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.message.Field;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ServiceType;
import urbi.UDictionary;

/** The services that one client calls, and those that it offers. */
final class Services implements AutoCloseable {
  private static final int MOST = 1000;

  /** Seconds in which a service has to answer, unless the client says how many. */
  private static final int PATIENCE = 60;

  private final Node node;
  private final Replies replies;
  private final RosApi api;
  private final Map<String, CompletableFuture<ServiceClient>> clients = new ConcurrentHashMap<>();
  private final Map<String, ServiceServer> servers = new ConcurrentHashMap<>();
  private final Map<String, Asked> asked = new ConcurrentHashMap<>();
  private final AtomicInteger count = new AtomicInteger();

  private record Asked(String service, MessageType type, CompletableFuture<UDictionary> answer) {}

  Services(Node node, Replies replies) {
    this.node = node;
    this.replies = replies;
    api = new RosApi(node);
  }

  // ------------------------------------------------------------------ calling

  void call(Operation operation) {
    String service = operation.needed("service");
    // roslib says rosapi/topics, roslibpy /rosapi/topics.
    String plain = service.replaceFirst("^/", "");
    CompletionStage<Map<String, @Nullable Object>> answer =
        plain.startsWith(RosApi.PREFIX)
            ? api.answer(plain.substring(RosApi.PREFIX.length()), operation.object("args"))
            : ask(node.resolve(service), operation);
    answer.whenComplete((values, failure) -> {
      Map<String, @Nullable Object> response = new LinkedHashMap<>();
      response.put("op", "service_response");
      if (operation.id() != null) {
        response.put("id", operation.id());
      }
      response.put("service", service);
      response.put("values", failure == null ? values : Replies.reason(failure));
      response.put("result", failure == null);
      replies.answer(response, operation);
    });
  }

  private CompletionStage<Map<String, @Nullable Object>> ask(String service, Operation operation) {
    if (clients.size() >= MOST) {
      throw new BridgeException("too many services");
    }
    int seconds = operation.count("timeout") == 0 ? PATIENCE : operation.count("timeout");
    return clients
        .computeIfAbsent(service, name -> node.client(name, null, false))
        .whenComplete((client, failure) -> {
          if (failure != null) {
            clients.remove(service);
          }
        })
        .thenCompose(client ->
            client
                .request(
                    JsonMessages.message(
                        arguments(operation, client.type()), client.type().request()))
                .orTimeout(seconds, TimeUnit.SECONDS)
                .thenApply(response -> JsonMessages.json(response, client.type().response())))
        .exceptionallyCompose(failure ->
            CompletableFuture.failedFuture(
                failure.getCause() instanceof TimeoutException
                    ? new RosException(service + " has not answered within " + seconds + " s")
                    : failure));
  }

  /** By their names, or in the order of the fields. */
  private static Map<String, @Nullable Object> arguments(Operation operation, ServiceType type) {
    List<?> list = operation.list("args");
    if (list == null) {
      return operation.object("args");
    }
    List<Field> fields = type.request().definition().fields();
    if (list.size() > fields.size()) {
      throw new BridgeException(fields.size() + " arguments expected, not " + list.size());
    }
    Map<String, @Nullable Object> named = new LinkedHashMap<>();
    for (int i = 0; i < list.size(); i++) {
      named.put(fields.get(i).name(), list.get(i));
    }
    return named;
  }

  // ------------------------------------------------------------------ offering

  void advertise(Operation operation) {
    String service = node.resolve(operation.needed("service"));
    ServiceType type = node.definitions().service(operation.needed("type"));
    if (servers.size() >= MOST) {
      throw new BridgeException("too many services");
    }
    ServiceServer made =
        node.serve(service, type, request -> pass(operation.text("service"), type, request));
    servers.put(service, made);
  }

  private CompletionStage<UDictionary> pass(String service, ServiceType type, UDictionary request) {
    if (asked.size() >= MOST) {
      return CompletableFuture.failedFuture(
          new RosException("too many requests wait for an answer"));
    }
    String id = "service_request:" + service + ":" + count.incrementAndGet();
    CompletableFuture<UDictionary> answer = new CompletableFuture<>();
    asked.put(id, new Asked(service, type.response(), answer));
    Map<String, @Nullable Object> call = new LinkedHashMap<>();
    call.put("op", "call_service");
    call.put("id", id);
    call.put("service", service);
    call.put("args", JsonMessages.json(request, type.request()));
    replies.answer(JsonWriter.text(call));
    return answer;
  }

  void respond(Operation operation) {
    Asked waiting = asked.remove(operation.needed("id"));
    if (waiting == null) {
      throw new BridgeException("nobody waits for an answer to " + operation.id());
    }
    try {
      if (Boolean.FALSE.equals(operation.keys().get("result"))) {
        throw new RosException(
            waiting.service() + " has failed: " + operation.keys().get("values"));
      }
      waiting.answer().complete(JsonMessages.message(operation.object("values"), waiting.type()));
    } catch (RuntimeException e) {
      // Who has asked is told in any case.
      waiting.answer().completeExceptionally(new RosException(Replies.reason(e)));
      if (!(e instanceof RosException)) {
        throw e;
      }
    }
  }

  void unadvertise(Operation operation) {
    ServiceServer known = servers.remove(node.resolve(operation.needed("service")));
    if (known == null) {
      throw new BridgeException(operation.text("service") + " is not offered");
    }
    known.close();
  }

  @Override
  public void close() {
    servers.values().forEach(ServiceServer::close);
    new ArrayList<>(asked.values())
        .forEach(each ->
            each.answer()
                .completeExceptionally(new RosException(each.service() + ": its client has gone")));
    clients.values().forEach(each -> each.thenAccept(ServiceClient::close));
  }
}
