package org.urbi.ros.two;

import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.ActionServer;
import org.urbi.ros.graph.Actions;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ServiceType;

/**
 * The actions of a node of ROS 2. Each consists of three services and two topics, whose names begin
 * with its own.
 */
final class TwoActions implements Actions {
  static final String SEND_GOAL = "/_action/send_goal";
  static final String CANCEL_GOAL = "/_action/cancel_goal";
  static final String GET_RESULT = "/_action/get_result";
  static final String FEEDBACK = "/_action/feedback";
  static final String STATUS = "/_action/status";

  /** What {@code action_msgs/CancelGoal} answers. */
  static final int ERROR_NONE = 0;

  static final int ERROR_UNKNOWN_GOAL_ID = 2;
  static final int ERROR_GOAL_TERMINATED = 3;

  /** Those who come later get the status of goals, too. */
  static final Qos STATUS_QOS = Qos.LATCHED;

  private final TwoHost node;
  private final GoalIds ids;

  TwoActions(TwoHost node, byte[] identity) {
    this.node = node;
    ids = new GoalIds(identity);
  }

  @Override
  public CompletableFuture<ActionClient> client(String action, @Nullable ActionType type) {
    String full = node.resolve(action);
    if (type != null) return new TwoActionClient(this, full, own(type)).ready();
    return node.typeOfService(
            full + SEND_GOAL, "there is no action " + full + ": Ros.actions has all")
        .thenCompose(found -> new TwoActionClient(this, full, own(typeOf(found))).ready());
  }

  /** The type of an action, from the type of the service that takes its goals. */
  private ActionType typeOf(String sendGoal) {
    String end = "_SendGoal";
    return node.definitions()
        .action(
            sendGoal.endsWith(end)
                ? sendGoal.substring(0, sendGoal.length() - end.length())
                : sendGoal);
  }

  @Override
  public ActionServer serve(String action, ActionType type, ActionServer.Handler handler) {
    return new TwoActionServer(this, node.resolve(action), own(type), handler);
  }

  private static ActionType.Two own(ActionType type) {
    if (type instanceof ActionType.Two two) return two;
    throw new RosException(type.name() + " is an action of ROS 1");
  }

  TwoHost node() {
    return node;
  }

  /** The name of a new goal. */
  UUID newId() {
    return ids.next();
  }

  ServiceType cancelGoal() {
    return node.definitions().service("action_msgs/CancelGoal");
  }

  MessageType statusArray() {
    return node.definitions().message("action_msgs/GoalStatusArray");
  }
}
