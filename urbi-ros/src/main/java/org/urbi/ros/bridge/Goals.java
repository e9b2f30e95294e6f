package org.urbi.ros.bridge;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.Node;
import org.urbi.ros.message.ActionType;
import urbi.UDictionary;

/** The goals that one client has others pursue. */
final class Goals implements AutoCloseable {
  private static final int MOST = 1000;

  /** Seconds in which those goals are given up whose client has gone. */
  private static final int PATIENCE = 10;

  private final Node node;
  private final Replies replies;

  /** By the action, and the type that the client has said, if any. */
  private final Map<String, CompletableFuture<ActionClient>> clients = new ConcurrentHashMap<>();

  /** By the identities that the client has given them. */
  private final Map<String, Pursuit> pursued = new ConcurrentHashMap<>();

  Goals(Node node, Replies replies) {
    this.node = node;
    this.replies = replies;
  }

  /** Sends a goal; how it ends is told in any case. */
  void send(Operation operation) {
    String id = operation.needed("id");
    Pursuit made = new Pursuit(id, operation.needed("action"), operation);
    if (pursued.size() >= MOST) {
      throw new BridgeException("too many goals");
    }
    if (pursued.putIfAbsent(id, made) != null) {
      throw new BridgeException("there is a goal '" + id + "' already");
    }
    CompletableFuture.completedFuture(null)
        .thenCompose(nothing -> client(made.action, operation.text("action_type")))
        .thenCompose(made::begin)
        .whenComplete((outcome, failure) -> {
          pursued.remove(id);
          made.end(outcome, failure);
        });
  }

  private CompletableFuture<ActionClient> client(String name, String typeName) {
    String action = node.resolve(name);
    ActionType type = typeName.isEmpty() ? null : node.definitions().action(typeName);
    String key = action + " " + typeName;
    if (clients.size() >= MOST) {
      throw new BridgeException("too many actions");
    }
    return clients
        .computeIfAbsent(key, missing -> node.actions().client(action, type))
        .whenComplete((client, failure) -> {
          if (failure != null) {
            clients.remove(key);
          }
        });
  }

  void cancel(Operation operation) {
    Pursuit meant = pursued.get(operation.needed("id"));
    if (meant == null) {
      throw new BridgeException("there is no goal '" + operation.id() + "'");
    }
    meant
        .cancel()
        .exceptionally(failure -> {
          replies.failed(operation, failure);
          return false;
        });
  }

  /** What a client wanted who has gone nobody wants any more. */
  @Override
  public void close() {
    List<CompletableFuture<Boolean>> left = pursued.values().stream().map(Pursuit::cancel).toList();
    CompletableFuture.allOf(left.toArray(CompletableFuture[]::new))
        .orTimeout(PATIENCE, TimeUnit.SECONDS)
        .whenComplete((nothing, failure) ->
            clients.values().forEach(each -> each.thenAccept(ActionClient::close)));
  }

  /** A goal. */
  private final class Pursuit implements ActionClient.Listener {
    final String action;
    private final String id;
    private final Operation operation;
    private final CompletableFuture<ActionClient.Goal> goal = new CompletableFuture<>();
    private volatile @Nullable ActionType type;

    Pursuit(String id, String action, Operation operation) {
      this.id = id;
      this.action = action;
      this.operation = operation;
    }

    CompletableFuture<ActionClient.Outcome> begin(ActionClient client) {
      type = client.type();
      UDictionary wanted = JsonMessages.message(operation.object("args"), client.type().goal());
      ActionClient.Goal sent = client.send(wanted, this);
      goal.complete(sent);
      return sent.outcome();
    }

    /** Cancels the goal, as soon as it has been sent. */
    CompletableFuture<Boolean> cancel() {
      return goal.thenCompose(ActionClient.Goal::cancel);
    }

    private Map<String, @Nullable Object> message(String op) {
      Map<String, @Nullable Object> message = new LinkedHashMap<>();
      message.put("op", op);
      message.put("id", id);
      message.put("action", action);
      return message;
    }

    @Override
    public void feedback(UDictionary feedback) {
      ActionType known = type;
      if (known == null || !operation.truth("feedback")) {
        return;
      }
      Map<String, @Nullable Object> message = message("action_feedback");
      message.put("values", JsonMessages.json(feedback, known.feedback()));
      replies.publish(message, operation, this);
    }

    void end(ActionClient.@Nullable Outcome outcome, @Nullable Throwable failure) {
      Map<String, @Nullable Object> message = message("action_result");
      ActionType known = type;
      if (outcome != null && known != null) {
        message.put("values", JsonMessages.json(outcome.result(), known.result()));
        message.put("status", outcome.status().number());
      } else {
        goal.completeExceptionally(new BridgeException("the goal was not sent"));
        message.put("values", failure == null ? "" : Replies.reason(failure));
        message.put("status", GoalStatus.UNKNOWN.number());
      }
      message.put("result", outcome != null);
      replies.answer(message, operation);
    }
  }
}
