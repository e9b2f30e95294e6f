package org.urbi.ros.uobject;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.RosException;
import urbi.UDictionary;
import urbi.UEvent;
import urbi.UObject;
import urbi.UVar;

/** A goal that urbiscript sends to an action. When it is destroyed, the server is to give it up. */
public final class RosGoal extends UObject implements MessageReceiver, AutoCloseable {
  static {
    UStart(RosGoal.class);
  }

  /** So many feedbacks wait for urbiscript at most; the oldest are dropped. */
  private static final int MOST = 100;

  /** What the status is when nobody knows what becomes of the goal. */
  private static final String LOST = "lost";

  private static final String NOT_SENT = "the goal was not sent";

  private final UEvent onFeedback = new UEvent();
  private final UVar feedback = new UVar();
  private final UVar status = new UVar();
  private final Delivery<UDictionary> delivery = new Delivery<>(() -> MessageReceiver.soon(this));
  private @Nullable RosAction action;
  private ActionClient.@Nullable Goal sent;
  private volatile String latest = GoalStatus.UNKNOWN.toString();

  /** How it has ended, after the status says so. */
  private CompletionStage<ActionClient.Outcome> ended =
      CompletableFuture.failedFuture(new RosException(NOT_SENT));

  public RosGoal(String name) {
    super(name);
    UBindEvent(onFeedback, "onFeedback");
    UBindVars(feedback, "feedback", status, "status");
    status.setValue(latest);
    UBindFunctions("send", "result", "cancel");
  }

  /**
   * Sends it. The job waits until the server has accepted it.
   *
   * @param actionName the name of the UObject that is the action
   */
  public CompletionStage<Void> send(String actionName, UDictionary goal) {
    if (!(getUObject(actionName) instanceof RosAction target)) {
      throw new RosException("an action expected, not " + actionName);
    }
    if (sent != null) {
      throw new RosException("the goal was sent already");
    }
    long most = target.patience().milliseconds();
    action = target;
    delivery.begin(MOST);
    ActionClient.Goal started = target.client().send(goal, new Progress());
    sent = started;
    ended =
        started
            .outcome()
            .whenComplete(
                (outcome, failure) -> tell(failure == null ? outcome.status().toString() : LOST));
    return Patience.within(most, target.name(), started.accepted().copy());
  }

  /** The status is another one; called by threads of the network. */
  private void tell(String now) {
    latest = now;
    MessageReceiver.soon(this);
  }

  private ActionClient.Goal sent() {
    ActionClient.Goal known = sent;
    if (known == null) {
      throw new RosException(NOT_SENT);
    }
    return known;
  }

  /** The result, whether the goal was reached or not. The job waits until the goal has ended. */
  public CompletionStage<UDictionary> result() {
    return ended.thenApply(ActionClient.Outcome::result);
  }

  /** Has the server give it up. The job waits until it is told whether the server does. */
  public CompletionStage<Boolean> cancel() {
    return sent().cancel();
  }

  @Override
  public void take() {
    RosAction of = action;
    boolean isAll =
        delivery.take(next -> {
          feedback.setValue(next);
          onFeedback.emit(next);
          if (of != null) {
            of.emit(next);
          }
        });
    String now = latest;
    // The end is told after the last feedback.
    if (isAll && !now.equals(status.stringValue())) {
      status.setValue(now);
    }
  }

  @Override
  public void close() {
    delivery.end();
    ActionClient.Goal known = sent;
    if (known == null || known.outcome().isDone()) {
      return;
    }
    String name = action == null ? "" : action.name();
    known
        .cancel()
        .thenAccept(isGivenUp -> {
          if (!isGivenUp) {
            getUContext().report("ROS: " + name + " does not give a goal up");
          }
        });
  }

  private final class Progress implements ActionClient.Listener {
    @Override
    public void feedback(UDictionary told) {
      delivery.offer(told);
    }

    @Override
    public void status(GoalStatus now) {
      tell(now.toString());
    }
  }
}
