package org.urbi.ros.bridge;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.ActionServer;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.Node;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.Templates;

/** The actions that one client offers, and the goals that it pursues. */
final class OfferedActions implements AutoCloseable {
  private static final int MOST = 1000;

  private final Node node;
  private final Replies replies;
  private final Map<String, ActionServer> servers = new ConcurrentHashMap<>();

  /** By the identities that the client knows them by. */
  private final Map<String, Pursued> goals = new ConcurrentHashMap<>();

  private final AtomicInteger count = new AtomicInteger();

  private record Pursued(String action, ActionType type, ActionServer.Goal goal) {}

  OfferedActions(Node node, Replies replies) {
    this.node = node;
    this.replies = replies;
  }

  void advertise(Operation operation) {
    String action = operation.needed("action");
    ActionType type = node.definitions().action(operation.needed("type"));
    if (servers.size() >= MOST) {
      throw new BridgeException("too many actions");
    }
    String full = node.resolve(action);
    if (servers.containsKey(full)) {
      throw new BridgeException(action + " is offered already");
    }
    servers.put(full, node.actions().serve(action, type, new Passing(action, type)));
  }

  void unadvertise(Operation operation) {
    ActionServer known = servers.remove(node.resolve(operation.needed("action")));
    if (known == null) {
      throw new BridgeException(operation.text("action") + " is not offered");
    }
    String action = operation.text("action");
    goals.values().removeIf(each -> each.action.equals(action));
    known.close();
  }

  private Pursued meant(Operation operation) {
    Pursued meant = goals.get(operation.needed("id"));
    if (meant == null) {
      throw new BridgeException("nobody waits for the goal '" + operation.id() + "'");
    }
    return meant;
  }

  /** The client tells how far it is. */
  void feedback(Operation operation) {
    Pursued meant = meant(operation);
    meant.goal.feedback(JsonMessages.message(operation.object("values"), meant.type.feedback()));
  }

  /** The client has ended a goal. */
  void end(Operation operation) {
    Pursued meant = meant(operation);
    boolean failed = Boolean.FALSE.equals(operation.keys().get("result"));
    GoalStatus status = GoalStatus.of(operation.count("status"));
    try {
      if (failed) {
        meant.goal.end(GoalStatus.ABORTED, Templates.of(meant.type.result()));
      } else if (status.isEnd()) {
        meant.goal.end(
            status, JsonMessages.message(operation.object("values"), meant.type.result()));
      } else {
        throw new BridgeException("'status': 4 (succeeded), 5 (canceled) or 6 (aborted) expected");
      }
    } catch (RuntimeException e) {
      // Whoever waits is told in any case.
      meant.goal.end(GoalStatus.ABORTED, Templates.of(meant.type.result()));
      throw e;
    } finally {
      goals.remove(operation.needed("id"));
    }
  }

  @Override
  public void close() {
    servers.values().forEach(ActionServer::close);
    goals.clear();
  }

  /** Has the client pursue what is wanted of one of its actions. */
  private final class Passing implements ActionServer.Handler {
    private final String action;
    private final ActionType type;

    Passing(String action, ActionType type) {
      this.action = action;
      this.type = type;
    }

    @Override
    public CompletionStage<Boolean> goal(ActionServer.Goal goal) {
      if (goals.size() >= MOST) {
        return CompletableFuture.completedFuture(false);
      }
      String id = "action_goal:" + action + ":" + count.incrementAndGet();
      goals.put(id, new Pursued(action, type, goal));
      Map<String, @Nullable Object> call = message("send_action_goal", id);
      call.put("action_type", type.name().in(node.version()));
      call.put("args", JsonMessages.json(goal.request(), type.goal()));
      call.put("feedback", true);
      replies.answer(JsonWriter.text(call));
      return CompletableFuture.completedFuture(true);
    }

    @Override
    public void cancel(ActionServer.Goal goal) {
      goals.forEach((id, pursued) -> {
        if (pursued.goal == goal) {
          replies.answer(JsonWriter.text(message("cancel_action_goal", id)));
        }
      });
    }

    private Map<String, @Nullable Object> message(String op, String id) {
      Map<String, @Nullable Object> message = new LinkedHashMap<>();
      message.put("op", op);
      message.put("id", id);
      message.put("action", action);
      return message;
    }
  }
}
