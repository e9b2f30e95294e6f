package org.urbi.ros.one;

import static org.urbi.ros.one.OneActions.part;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.ActionServer;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** An action of ROS 1 that this node offers. */
final class OneActionServer implements ActionServer {
  /** How often clients are told that the server is there, in milliseconds: as actionlib does. */
  private static final int PERIOD = 200;

  /** What has ended is told for so many seconds. */
  private static final int KEPT_SECONDS = 5;

  private static final Executor LATER =
      CompletableFuture.delayedExecutor(KEPT_SECONDS, TimeUnit.SECONDS, Threads.POOL);
  private static final Executor SOON =
      CompletableFuture.delayedExecutor(PERIOD, TimeUnit.MILLISECONDS, Threads.POOL);

  private final OneActions actions;
  private final OneNode node;
  private final String action;
  private final ActionType.One type;
  private final Handler handler;
  private final MessageCodec results;
  private final MessageType statusArray;

  /** By the identities that their clients have given them. */
  private final Map<String, ServedGoal> goals = new LinkedHashMap<>();

  private final Publisher status;
  private final Publisher feedback;
  private final Publisher result;
  private final Subscription goal;
  private final Subscription cancel;
  private long cancelled;
  private boolean closed;

  OneActionServer(OneActions actions, String action, ActionType.One type, Handler handler) {
    this.action = action;
    this.type = type;
    this.handler = handler;
    this.actions = actions;
    node = actions.node();
    results = MessageCodec.of(type.result());
    statusArray = actions.statusArray();
    Publisher.Listener nobody = new Publisher.Listener() {};
    status = node.advertise(action + OneActions.STATUS, statusArray, OneActions.QOS, nobody);
    feedback =
        node.advertise(
            action + OneActions.FEEDBACK, type.feedbackMessage(), OneActions.QOS, nobody);
    result =
        node.advertise(action + OneActions.RESULT, type.resultMessage(), OneActions.QOS, nobody);
    goal =
        node.subscribe(
            action + OneActions.GOAL, type.goalMessage(), OneActions.QOS, this::goalReceived);
    cancel =
        node.subscribe(
            action + OneActions.CANCEL, actions.goalId(), OneActions.QOS, this::cancelReceived);
    beat();
  }

  @Override
  public String action() {
    return action;
  }

  @Override
  public ActionType type() {
    return type;
  }

  /** Clients believe a server to be there as long as it tells of its goals. */
  private synchronized void beat() {
    if (closed) {
      return;
    }
    tell();
    SOON.execute(this::beat);
  }

  // ------------------------------------------------------------------ what clients want

  private void goalReceived(UDictionary message) {
    ServedGoal wanted;
    synchronized (this) {
      UDictionary id = part(message, "goal_id").udictionaryValue();
      wanted = new ServedGoal(id, part(message, "goal").udictionaryValue());
      if (closed || goals.putIfAbsent(wanted.id, wanted) != null) {
        return;
      }
      if (running() > OneActions.MOST) {
        wanted.refuse("too many goals");
        return;
      }
      if (wanted.stamp() > 0 && wanted.stamp() <= cancelled) {
        // Whoever wanted all before that time to be given up meant this one, too.
        wanted.asked = true;
        wanted.end(GoalStatus.CANCELED, Templates.of(type.result()));
        return;
      }
    }
    CompletionStage<Boolean> accepted;
    try {
      accepted = handler.goal(wanted);
    } catch (RuntimeException e) {
      accepted = CompletableFuture.failedFuture(e);
    }
    accepted.whenComplete((good, failure) -> {
      if (failure == null && good) {
        wanted.begin();
      } else {
        wanted.refuse("");
      }
    });
  }

  /** One of an identity, those that were sent until a time, or all if neither is given. */
  private void cancelReceived(UDictionary message) {
    String id = OneActions.id(message);
    long until = Templates.nanoseconds(part(message, "stamp").udictionaryValue());
    List<ServedGoal> meant;
    synchronized (this) {
      cancelled = Math.max(cancelled, until);
      boolean isAll = id.isEmpty() && until == 0;
      meant =
          goals.values().stream()
              .filter(each -> isAll || each.id.equals(id) || until > 0 && each.stamp() <= until)
              .toList();
    }
    meant.forEach(ServedGoal::cancel);
  }

  // ------------------------------------------------------------------ what has become of them

  private long running() {
    return goals.values().stream().filter(each -> !each.hasEnded()).count();
  }

  private void tell() {
    UList all = new UList();
    goals.values().forEach(each -> all.add(new UValue(each.status(""))));
    status.publish(headed(statusArray).with("status_list", new UValue(all)));
  }

  private UDictionary headed(MessageType wanted) {
    UDictionary message = Templates.of(wanted);
    part(message, "header").udictionaryValue().put("stamp", Templates.time(node.now()));
    return message;
  }

  private synchronized void forget(ServedGoal one) {
    goals.remove(one.id, one);
  }

  @Override
  public void close() {
    List<ServedGoal> left;
    synchronized (this) {
      if (closed) {
        return;
      }
      left = List.copyOf(goals.values());
      left.forEach(each -> each.end(GoalStatus.ABORTED, Templates.of(type.result())));
      closed = true;
    }
    actions.closed(this);
    goal.close();
    cancel.close();
    Stream.of(status, feedback, result).forEach(Publisher::close);
  }

  /** The lock of the server guards it. */
  private final class ServedGoal implements Goal {
    final String id;
    private final UDictionary goalId;
    private final UDictionary request;
    private int number = OneActions.number(GoalStatus.UNKNOWN);
    private boolean asked;

    ServedGoal(UDictionary goalId, UDictionary request) {
      this.goalId = goalId;
      this.request = request;
      id = OneActions.id(goalId);
    }

    long stamp() {
      return Templates.nanoseconds(part(goalId, "stamp").udictionaryValue());
    }

    private GoalStatus current() {
      return OneActions.status(number);
    }

    private boolean hasEnded() {
      return number == OneActions.REJECTED || current().isEnd();
    }

    private UDictionary status(String text) {
      return new UDictionary().with("goal_id", goalId).with("status", number).with("text", text);
    }

    /** The goal is pursued from now on, if it has not ended at once. */
    void begin() {
      boolean wasAsked;
      synchronized (OneActionServer.this) {
        if (current() != GoalStatus.UNKNOWN || hasEnded()) {
          return;
        }
        number = OneActions.number(asked ? GoalStatus.CANCELING : GoalStatus.EXECUTING);
        wasAsked = asked;
        tell();
      }
      if (wasAsked) {
        handler.cancel(this);
      }
    }

    void refuse(String why) {
      synchronized (OneActionServer.this) {
        if (!hasEnded()) {
          finish(OneActions.REJECTED, why, Templates.of(type.result()));
        }
      }
    }

    void cancel() {
      synchronized (OneActionServer.this) {
        asked = true;
        if (current() != GoalStatus.EXECUTING) {
          return;
        }
        number = OneActions.number(GoalStatus.CANCELING);
        tell();
      }
      handler.cancel(this);
    }

    private void finish(int end, String text, UDictionary told) {
      number = end;
      result.publish(
          headed(type.resultMessage()).with("status", status(text)).with("result", told));
      tell();
      LATER.execute(() -> forget(this));
    }

    @Override
    public UDictionary request() {
      return request;
    }

    @Override
    public void feedback(UDictionary told) {
      synchronized (OneActionServer.this) {
        if (!hasEnded()) {
          feedback.publish(
              headed(type.feedbackMessage()).with("status", status("")).with("feedback", told));
        }
      }
    }

    @Override
    public void end(GoalStatus wanted, UDictionary told) {
      results.encode(told);
      synchronized (OneActionServer.this) {
        if (!hasEnded()) {
          boolean isNot = wanted == GoalStatus.CANCELED && !asked;
          finish(OneActions.number(isNot ? GoalStatus.ABORTED : wanted), "", told);
        }
      }
    }
  }
}
