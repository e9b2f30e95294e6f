package org.urbi.ros.two;

import static org.urbi.ros.two.GoalIds.part;

import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.SentGoal;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UValue;

/** What has an action of ROS 2 pursue goals. */
final class TwoActionClient implements ActionClient {
  private final TwoActions actions;
  private final TwoHost node;
  private final String action;
  private final ActionType.Two type;
  private final Map<UUID, TwoGoal> goals = new ConcurrentHashMap<>();
  private final Subscription feedback;
  private final Subscription status;
  private final CompletableFuture<ServiceClient> sendGoal;
  private final CompletableFuture<ServiceClient> cancelGoal;
  private final CompletableFuture<ServiceClient> getResult;

  TwoActionClient(TwoActions actions, String action, ActionType.Two type) {
    this.actions = actions;
    this.node = actions.node();
    this.action = action;
    this.type = type;
    // Servers get to know these before those of the services, and lose no feedback therefore.
    feedback =
        hear(TwoActions.FEEDBACK, type.feedbackMessage(), Qos.DEFAULT, this::feedbackReceived);
    status =
        hear(
            TwoActions.STATUS,
            actions.statusArray(),
            TwoActions.STATUS_QOS,
            message -> part(message, "status_list").ulistValue().forEach(this::statusReceived));
    sendGoal = node.client(action + TwoActions.SEND_GOAL, type.sendGoal(), true);
    cancelGoal = node.client(action + TwoActions.CANCEL_GOAL, actions.cancelGoal(), true);
    getResult = node.client(action + TwoActions.GET_RESULT, type.getResult(), true);
  }

  private Subscription hear(
      String topic, MessageType message, Qos qos, Consumer<UDictionary> action) {
    return node.subscribe(
        this.action + topic,
        message,
        qos,
        new Subscription.Listener() {
          @Override
          public void received(UDictionary told) {
            action.accept(told);
          }

          @Override
          public void failed(String reason) {
            node.reports().tell(TwoActionClient.this.action + ": " + reason);
          }
        });
  }

  /** Itself, when the server has all that an action consists of. */
  CompletableFuture<ActionClient> ready() {
    return CompletableFuture.allOf(sendGoal, cancelGoal, getResult)
        .<ActionClient>thenApply(all -> this)
        .whenComplete((itself, failure) -> {
          if (failure != null) close();
        });
  }

  @Override
  public String action() {
    return action;
  }

  @Override
  public ActionType type() {
    return type;
  }

  @Override
  public Goal send(UDictionary goal, Listener listener) {
    TwoGoal sent = new TwoGoal(listener);
    goals.put(sent.id, sent);
    sent.outcome().whenComplete((outcome, failure) -> goals.remove(sent.id));
    UDictionary request = request(sent.id).with("goal", goal);
    try {
      sendGoal.join().request(request).whenComplete(sent::answered);
    } catch (RuntimeException e) {
      sent.fail(e);
      throw e;
    }
    return sent;
  }

  private static UDictionary request(UUID id) {
    return new UDictionary().with("goal_id", GoalIds.message(id));
  }

  private static boolean isGivenUp(UDictionary answer) {
    int code = part(answer, "return_code").intValue();
    // Servers that refuse need not say so by the code.
    return code == TwoActions.ERROR_GOAL_TERMINATED
        || code == TwoActions.ERROR_NONE && !part(answer, "goals_canceling").ulistValue().isEmpty();
  }

  private void feedbackReceived(UDictionary message) {
    TwoGoal sent = goals.get(GoalIds.of(message));
    if (sent != null) sent.feedback(part(message, "feedback").udictionaryValue());
  }

  private void statusReceived(UValue each) {
    UDictionary told = each.udictionaryValue();
    TwoGoal sent = goals.get(GoalIds.of(part(told, "goal_info").udictionaryValue()));
    if (sent != null) sent.told(GoalStatus.of(part(told, "status").intValue()));
  }

  @Override
  public void close() {
    RosException reason = new RosException("the client of " + action + " is closed");
    goals.values().forEach(each -> each.fail(reason));
    feedback.close();
    status.close();
    Stream.of(sendGoal, cancelGoal, getResult)
        .forEach(each -> each.thenAccept(ServiceClient::close));
  }

  private final class TwoGoal extends SentGoal {
    final UUID id = actions.newId();

    TwoGoal(Listener listener) {
      super(listener);
    }

    void answered(@Nullable UDictionary answer, @Nullable Throwable failure) {
      if (answer == null || failure != null) {
        fail(failure == null ? new RosException(action + " gives no answer") : failure);
      } else if (!part(answer, "accepted").booleanValue()) {
        fail(new RosException(action + " refuses the goal"));
      } else {
        // Asked before anybody can have it cancelled: the answer comes when the goal has ended.
        getResult.join().request(request(id)).whenComplete(this::ended);
        told(GoalStatus.ACCEPTED);
        accept();
      }
    }

    private void ended(@Nullable UDictionary answer, @Nullable Throwable failure) {
      if (answer == null || failure != null) {
        fail(failure == null ? new RosException(action + " gives no answer") : failure);
        return;
      }
      GoalStatus end = GoalStatus.of(part(answer, "status").intValue());
      if (end.isEnd()) end(new Outcome(end, part(answer, "result").udictionaryValue()));
      else fail(new RosException(action + " does not know the goal any more"));
    }

    @Override
    public CompletableFuture<Boolean> cancel() {
      UDictionary request = Templates.of(actions.cancelGoal().request());
      part(request, "goal_info").udictionaryValue().put("goal_id", GoalIds.message(id));
      return accepted()
          .thenCompose(now -> cancelGoal.join().request(request))
          .thenApply(TwoActionClient::isGivenUp);
    }
  }
}
