package org.urbi.ros.one;

import static org.urbi.ros.one.OneActions.part;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.SentGoal;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UValue;

/** What has an action of ROS 1 pursue goals. */
final class OneActionClient implements ActionClient {
  /** Seconds in which a server that the master knows of has to say something. */
  private static final int PATIENCE = 5;

  private static final Executor LATER =
      CompletableFuture.delayedExecutor(PATIENCE, TimeUnit.SECONDS, Threads.POOL);

  private static final AtomicLong SENT = new AtomicLong();

  private final OneNode node;
  private final String action;
  private final ActionType.One type;
  private final CompletableFuture<ActionClient> ready = new CompletableFuture<>();
  private final Map<String, OneGoal> goals = new ConcurrentHashMap<>();
  private final UDictionary goalId;
  private final Publisher goal;
  private final Publisher cancel;
  private final Subscription feedback;
  private final Subscription result;
  private final Subscription status;

  /** Whether the server has told its status since all topics were connected. */
  private boolean isThere;

  OneActionClient(OneActions actions, String action, ActionType.One type) {
    this.action = action;
    this.type = type;
    node = actions.node();
    goalId = Templates.of(actions.goalId());
    goal =
        node.advertise(
            action + OneActions.GOAL, type.goalMessage(), OneActions.QOS, new ServerWatch());
    cancel =
        node.advertise(
            action + OneActions.CANCEL,
            actions.goalId(),
            OneActions.QOS,
            new Publisher.Listener() {});
    feedback =
        node.subscribe(
            action + OneActions.FEEDBACK,
            type.feedbackMessage(),
            OneActions.QOS,
            this::feedbackReceived);
    result =
        node.subscribe(
            action + OneActions.RESULT, type.resultMessage(), OneActions.QOS, this::resultReceived);
    status =
        node.subscribe(
            action + OneActions.STATUS,
            actions.statusArray(),
            OneActions.QOS,
            this::statusReceived);
  }

  /** Itself, when the server hears and is heard; it tells the status of its goals all the time. */
  CompletableFuture<ActionClient> ready() {
    return ready
        .orTimeout(PATIENCE, TimeUnit.SECONDS)
        .exceptionallyCompose(failure -> {
          close();
          return CompletableFuture.failedFuture(
              new RosException("the action " + action + " does not answer", failure));
        });
  }

  private final class ServerWatch implements Publisher.Listener {
    @Override
    public void disconnected(String name) {
      if (goal.subscribers() == 0) {
        failAll("the action " + action + " has gone");
      }
    }
  }

  private void failAll(String why) {
    goals.values().forEach(each -> each.fail(new RosException(why)));
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
  public Goal send(UDictionary wanted, Listener listener) {
    OneGoal sent = new OneGoal(listener);
    UDictionary message = Templates.of(type.goalMessage());
    UValue stamp = Templates.time(node.now());
    part(message, "header").udictionaryValue().put("stamp", stamp);
    message.with("goal_id", goalId(sent.id).with("stamp", stamp)).with("goal", wanted);
    goals.put(sent.id, sent);
    sent.outcome().whenComplete((outcome, failure) -> goals.remove(sent.id));
    try {
      if (goal.subscribers() == 0) {
        throw new RosException("the action " + action + " has gone");
      }
      goal.publish(message);
    } catch (RuntimeException e) {
      sent.fail(e);
      throw e;
    }
    return sent;
  }

  private UDictionary goalId(String id) {
    return new UDictionary().with("stamp", part(goalId, "stamp")).with("id", id);
  }

  private void feedbackReceived(UDictionary message) {
    OneGoal sent = told(part(message, "status").udictionaryValue());
    if (sent != null) {
      sent.feedback(part(message, "feedback").udictionaryValue());
    }
  }

  private void resultReceived(UDictionary message) {
    UDictionary ended = part(message, "status").udictionaryValue();
    OneGoal sent = told(ended);
    GoalStatus end = OneActions.status(part(ended, "status").intValue());
    if (sent != null && end.isEnd()) {
      sent.ended(new Outcome(end, part(message, "result").udictionaryValue()));
    }
  }

  private void statusReceived(UDictionary message) {
    boolean isHeard = goal.subscribers() > 0 && cancel.subscribers() > 0;
    if (isHeard && feedback.publishers() > 0 && result.publishers() > 0) {
      // A server that answers a connection may take it up a moment later: only what it says after
      // the next status is certain to be heard.
      if (isThere) {
        ready.complete(this);
      }
      isThere = true;
    }
    part(message, "status_list").ulistValue().forEach(each -> told(each.udictionaryValue()));
  }

  /** The goal of which a server tells, one of ours; null otherwise. */
  private @Nullable OneGoal told(UDictionary one) {
    OneGoal sent = goals.get(OneActions.id(part(one, "goal_id").udictionaryValue()));
    if (sent != null) {
      sent.told(part(one, "status").intValue(), part(one, "text").stringValue());
    }
    return sent;
  }

  @Override
  public void close() {
    failAll("the client of " + action + " is closed");
    Stream.of(feedback, result, status).forEach(Subscription::close);
    goal.close();
    cancel.close();
  }

  private final class OneGoal extends SentGoal {
    final String id = node.name() + "-" + SENT.incrementAndGet() + "-" + node.now();
    private final CompletableFuture<Boolean> givenUp = new CompletableFuture<>();
    private final AtomicBoolean hasEnded = new AtomicBoolean();

    OneGoal(Listener listener) {
      super(listener);
    }

    @Override
    public void fail(Throwable reason) {
      super.fail(reason);
      givenUp.completeExceptionally(reason);
    }

    void told(int number, String text) {
      GoalStatus now = OneActions.status(number);
      if (number == OneActions.REJECTED) {
        String why = text.isEmpty() ? "" : ": " + text;
        fail(new RosException(action + " refuses the goal" + why));
      } else if (now.isEnd()) {
        accept();
        awaitResult();
      } else if (told(now)) {
        accept();
        if (now == GoalStatus.CANCELING) {
          givenUp.complete(true);
        }
      }
    }

    /** The goal has ended; its result comes by another topic, if at all. */
    private void awaitResult() {
      if (!hasEnded.getAndSet(true)) {
        LATER.execute(
            () -> fail(new RosException(action + " has ended the goal, but tells no result")));
      }
    }

    void ended(Outcome how) {
      accept();
      givenUp.complete(true);
      end(how);
    }

    @Override
    public CompletableFuture<Boolean> cancel() {
      return accepted()
          .thenCompose(now -> {
            cancel.publish(goalId(id));
            return givenUp;
          });
    }
  }
}
