package org.urbi.ros.one;

import static java.util.Objects.requireNonNull;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.ActionServer;
import org.urbi.ros.graph.Actions;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.MessageType;
import urbi.UDictionary;
import urbi.UValue;

/**
 * The actions of a node of ROS 1: each consists of five topics, whose names begin with its own, as
 * {@code actionlib} has them.
 */
final class OneActions implements Actions {
  static final String GOAL = "/goal";
  static final String CANCEL = "/cancel";
  static final String STATUS = "/status";
  static final String FEEDBACK = "/feedback";
  static final String RESULT = "/result";

  /** As many goals may be under way at a time. */
  static final int MOST = 1000;

  /** Nothing of what is said of goals is to be dropped, within reason. */
  static final Qos QOS = new Qos(true, false, MOST, Qos.DEFAULT.deadline(), false);

  // The numbers of actionlib_msgs/GoalStatus, beside 1, 3 and 4: active, succeeded, aborted.
  private static final int PENDING = 0;
  private static final int ACTIVE = 1;
  private static final int PREEMPTED = 2;
  private static final int SUCCEEDED = 3;
  private static final int ABORTED = 4;
  static final int REJECTED = 5;
  private static final int PREEMPTING = 6;
  private static final int RECALLING = 7;
  private static final int RECALLED = 8;

  private final OneNode node;
  private final Map<String, OneActionServer> servers = new HashMap<>();

  OneActions(OneNode node) {
    this.node = node;
  }

  OneNode node() {
    return node;
  }

  /** The status with that number; {@link GoalStatus#UNKNOWN} for those that wait or are refused. */
  static GoalStatus status(int number) {
    return switch (number) {
      case ACTIVE -> GoalStatus.EXECUTING;
      case PREEMPTING, RECALLING -> GoalStatus.CANCELING;
      case SUCCEEDED -> GoalStatus.SUCCEEDED;
      case PREEMPTED, RECALLED -> GoalStatus.CANCELED;
      case ABORTED -> GoalStatus.ABORTED;
      default -> GoalStatus.UNKNOWN;
    };
  }

  /** The number of a status. */
  static int number(GoalStatus status) {
    return switch (status) {
      case UNKNOWN -> PENDING;
      case ACCEPTED, EXECUTING -> ACTIVE;
      case CANCELING -> PREEMPTING;
      case SUCCEEDED -> SUCCEEDED;
      case CANCELED -> PREEMPTED;
      case ABORTED -> ABORTED;
    };
  }

  /** A field of a message that was decoded, and has all that are in its type. */
  static UValue part(UDictionary message, String name) {
    return requireNonNull(message.get(name), "a decoded message has all its fields");
  }

  /** What tells one goal from others. */
  static String id(UDictionary goalId) {
    return part(goalId, "id").stringValue();
  }

  @Override
  public CompletableFuture<ActionClient> client(String action, @Nullable ActionType type) {
    String full = node.resolve(action);
    return node.graph()
        .thenCompose(graph -> {
          GraphSnapshot.ActionInfo info = graph.actions().get(full);
          if (info == null) {
            throw new RosException("there is no action " + full + ": Ros.actions has all");
          }
          ActionType known = type != null ? type : node.definitions().action(info.type());
          return new OneActionClient(this, full, own(known)).ready();
        });
  }

  @Override
  public ActionServer serve(String action, ActionType type, ActionServer.Handler handler) {
    String full = node.resolve(action);
    ActionType.One known = own(type);
    synchronized (servers) {
      if (servers.containsKey(full)) {
        throw new RosException(full + " is offered by this node already");
      }
      OneActionServer made = new OneActionServer(this, full, known, handler);
      servers.put(full, made);
      return made;
    }
  }

  /** One of the servers has been closed. */
  void closed(OneActionServer server) {
    synchronized (servers) {
      servers.remove(server.action());
    }
  }

  /** Ends what this node offers. */
  void close() {
    List<OneActionServer> left;
    synchronized (servers) {
      left = List.copyOf(servers.values());
    }
    left.forEach(OneActionServer::close);
  }

  private static ActionType.One own(ActionType type) {
    if (type instanceof ActionType.One one) {
      return one;
    }
    throw new RosException(type.name() + " is an action of ROS 2");
  }

  MessageType goalId() {
    return node.definitions().message("actionlib_msgs/GoalID");
  }

  MessageType statusArray() {
    return node.definitions().message("actionlib_msgs/GoalStatusArray");
  }
}
