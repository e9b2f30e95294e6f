package org.urbi.ros.uobject;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.ActionServer;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UEvent;
import urbi.UObject;

/**
 * An action that urbiscript offers: each goal is an event, with a number by which urbiscript speaks
 * of it. {@code Ros.offerAction} in {@code ros.u} makes one of a function.
 */
public final class RosActionServer extends UObject implements AutoCloseable {
  static {
    UStart(RosActionServer.class);
  }

  /** A goal, and whether it is accepted. */
  private record Asked(ActionServer.Goal goal, CompletableFuture<Boolean> accepted) {}

  private final UEvent onGoal = new UEvent();
  private final UEvent onCancel = new UEvent();
  private final Map<Integer, Asked> asked = new ConcurrentHashMap<>();
  private final Map<ActionServer.Goal, Integer> numbers = new ConcurrentHashMap<>();
  private final AtomicInteger count = new AtomicInteger();
  private volatile String action = "";
  private volatile @Nullable ActionServer server;
  private boolean closed;

  public RosActionServer(String name) {
    super(name);
    UBindEvent(onGoal, "onGoal");
    UBindEvent(onCancel, "onCancel");
    UBindFunctions(
        "begin",
        "name",
        "resultStruct",
        "feedbackStruct",
        "accept",
        "refuse",
        "feedback",
        "end",
        "report",
        "close");
  }

  /** Offers an action. The job waits until the others can know. */
  public CompletionStage<Void> begin(String name, String type) {
    return Ros.of(this)
        .thenCompose(node -> {
          ActionType known = node.definitions().action(type);
          return node.prepared(known.goal()).thenCompose(ready -> serve(node, name, known));
        });
  }

  private CompletionStage<Void> serve(Node node, String name, ActionType type) {
    checkOpen(name);
    action = node.resolve(name);
    ActionServer made = node.actions().serve(name, type, new Goals());
    if (!keep(made)) {
      made.close();
      checkOpen(name);
    }
    return node.settled();
  }

  private synchronized void checkOpen(String name) {
    if (closed) {
      throw new RosException(name + " is not offered any more");
    }
  }

  private synchronized boolean keep(ActionServer made) {
    if (!closed) {
      server = made;
    }
    return !closed;
  }

  /** Returns what is to be closed, without the monitor: what hears of it may let others run. */
  private synchronized @Nullable ActionServer retire() {
    closed = true;
    ActionServer known = server;
    server = null;
    return known;
  }

  private final class Goals implements ActionServer.Handler {
    @Override
    public CompletionStage<Boolean> goal(ActionServer.Goal goal) {
      CompletableFuture<Boolean> accepted = new CompletableFuture<>();
      int number = count.incrementAndGet();
      asked.put(number, new Asked(goal, accepted));
      numbers.put(goal, number);
      onGoal.emit(number, goal.request());
      return accepted;
    }

    @Override
    public void cancel(ActionServer.Goal goal) {
      Integer number = numbers.get(goal);
      if (number != null) {
        onCancel.emit(number);
      }
    }
  }

  private ActionServer server() {
    ActionServer known = server;
    if (known == null) {
      throw new RosException("no action is offered");
    }
    return known;
  }

  /** The full name of the action. */
  public String name() {
    return server().action();
  }

  /** A new result. */
  public UDictionary resultStruct() {
    return Templates.of(server().type().result());
  }

  /** A new feedback. */
  public UDictionary feedbackStruct() {
    return Templates.of(server().type().feedback());
  }

  /** A goal is pursued from now on. */
  public void accept(int number) {
    Asked known = asked.get(number);
    if (known != null) {
      known.accepted.complete(true);
    }
  }

  /** A goal is not pursued; without effect if it is already. */
  public void refuse(int number) {
    Asked known = forget(number);
    if (known != null) {
      known.accepted.complete(false);
    }
  }

  private @Nullable Asked forget(int number) {
    Asked known = asked.remove(number);
    if (known != null) {
      numbers.remove(known.goal);
    }
    return known;
  }

  /** Tells the client how far it is. */
  public void feedback(int number, UDictionary message) {
    Asked known = asked.get(number);
    if (known != null) {
      known.goal.feedback(message);
    }
  }

  /**
   * Ends a goal.
   *
   * @param status succeeded, canceled or aborted
   */
  public void end(int number, String status, UDictionary result) {
    GoalStatus end =
        switch (status) {
          case "succeeded" -> GoalStatus.SUCCEEDED;
          case "canceled" -> GoalStatus.CANCELED;
          case "aborted" -> GoalStatus.ABORTED;
          default ->
              throw new RosException("status: succeeded, canceled or aborted, not " + status);
        };
    Asked known = asked.get(number);
    if (known != null) {
      known.goal.end(end, result);
      forget(number);
    }
  }

  /** Tells people of what went wrong: ROS has no way to tell the client why. */
  public void report(String reason) {
    getUContext().report("ROS: " + action + " failed: " + reason);
  }

  /** Ends the action, and the goals with it. */
  @Override
  public void close() {
    ActionServer known = retire();
    if (known != null) {
      known.close();
    }
    for (int number : asked.keySet()) {
      onCancel.emit(number);
      refuse(number);
    }
  }
}
