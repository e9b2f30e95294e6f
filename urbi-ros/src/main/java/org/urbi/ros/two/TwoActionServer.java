package org.urbi.ros.two;

import static org.urbi.ros.two.GoalIds.part;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.ActionServer;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** An action of ROS 2 that this node offers. */
final class TwoActionServer implements ActionServer {
  /** Goals that are pursued at a time, and requests for a result that wait; more are refused. */
  private static final int MOST = 1000;

  /** Goals that have ended whose results are kept, the newest ones, and for so many seconds. */
  private static final int MOST_ENDED = 100;

  private static final int KEPT_SECONDS = 60;
  private static final Executor LATER =
      CompletableFuture.delayedExecutor(KEPT_SECONDS, TimeUnit.SECONDS);

  private final TwoActions actions;
  private final String action;
  private final ActionType.Two type;
  private final Handler handler;
  private final MessageCodec results;
  private final Map<UUID, ServedGoal> goals = new LinkedHashMap<>();
  private final Publisher feedback;
  private final Publisher status;
  private final List<ServiceServer> services = new ArrayList<>();
  private int waiting;
  private boolean closed;

  TwoActionServer(TwoActions actions, String action, ActionType.Two type, Handler handler) {
    this.actions = actions;
    this.action = action;
    this.type = type;
    this.handler = handler;
    results = MessageCodec.of(type.result());
    // A goal may come as soon as a service is there, and what it leads to is published.
    feedback = advertise(TwoActions.FEEDBACK, type.feedbackMessage(), Qos.DEFAULT);
    status = advertise(TwoActions.STATUS, actions.statusArray(), TwoActions.STATUS_QOS);
    try {
      serve(TwoActions.SEND_GOAL, type.sendGoal(), this::goalReceived);
      serve(TwoActions.CANCEL_GOAL, actions.cancelGoal(), this::cancelReceived);
      serve(TwoActions.GET_RESULT, type.getResult(), this::resultWanted);
    } catch (RuntimeException e) {
      closeParts();
      throw e;
    }
  }

  private Publisher advertise(String part, MessageType what, Qos qos) {
    return actions.node().advertise(action + part, what, qos, new Publisher.Listener() {});
  }

  private void serve(String part, ServiceType what, ServiceServer.Handler answers) {
    services.add(actions.node().serve(action + part, what, answers));
  }

  @Override
  public String action() {
    return action;
  }

  @Override
  public ActionType type() {
    return type;
  }

  // ------------------------------------------------------------------ what clients want

  private CompletionStage<UDictionary> goalReceived(UDictionary request) {
    ServedGoal goal = new ServedGoal(GoalIds.of(request), part(request, "goal").udictionaryValue());
    synchronized (this) {
      if (closed || running() >= MOST || goals.putIfAbsent(goal.id, goal) != null)
        return CompletableFuture.completedFuture(answer(false, goal));
    }
    return handler
        .goal(goal)
        .handle((accepted, failure) -> answer(failure == null && accepted, goal));
  }

  private UDictionary answer(boolean accepted, ServedGoal goal) {
    if (accepted) goal.begin();
    else forget(goal);
    return new UDictionary().with("accepted", accepted ? 1 : 0).with("stamp", goal.stamp());
  }

  private CompletionStage<UDictionary> resultWanted(UDictionary request) {
    ServedGoal goal;
    synchronized (this) {
      goal = goals.get(GoalIds.of(request));
      if (goal != null && waiting >= MOST)
        throw new RosException("too many requests wait for a result");
      waiting++;
    }
    CompletableFuture<UDictionary> outcome =
        goal == null
            ? CompletableFuture.completedFuture(
                ended(GoalStatus.UNKNOWN, Templates.of(type.result())))
            : goal.outcome;
    return outcome.whenComplete((result, failure) -> {
      synchronized (this) {
        waiting--;
      }
    });
  }

  private static UDictionary ended(GoalStatus status, UDictionary result) {
    return new UDictionary().with("status", status.number()).with("result", result);
  }

  private CompletionStage<UDictionary> cancelReceived(UDictionary request) {
    UDictionary info = part(request, "goal_info").udictionaryValue();
    UUID id = GoalIds.of(info);
    long until = Templates.nanoseconds(part(info, "stamp").udictionaryValue());
    boolean isAll = id.equals(GoalIds.ALL) && until == 0;
    List<ServedGoal> wanted =
        chosen(goal -> isAll || goal.id.equals(id) || until > 0 && goal.accepted <= until);
    List<ServedGoal> ended = wanted.stream().filter(goal -> goal.current().isEnd()).toList();
    UList canceling = new UList();
    for (ServedGoal each : wanted) if (each.cancel()) canceling.add(new UValue(each.info()));
    int code = TwoActions.ERROR_NONE;
    if (canceling.isEmpty() && !id.equals(GoalIds.ALL))
      code = ended.isEmpty() ? TwoActions.ERROR_UNKNOWN_GOAL_ID : TwoActions.ERROR_GOAL_TERMINATED;
    return CompletableFuture.completedFuture(
        new UDictionary().with("return_code", code).with("goals_canceling", new UValue(canceling)));
  }

  private synchronized List<ServedGoal> chosen(Predicate<ServedGoal> wanted) {
    return goals.values().stream().filter(wanted).toList();
  }

  // ------------------------------------------------------------------ what has become of them

  private int running() {
    return (int) goals.values().stream().filter(each -> !each.current().isEnd()).count();
  }

  /** Tells the status of all goals, in the order of what has happened. */
  private void tell() {
    UList all = new UList();
    for (ServedGoal each : chosen(goal -> goal.current() != GoalStatus.UNKNOWN)) {
      UDictionary one =
          new UDictionary().with("goal_info", each.info()).with("status", each.current().number());
      all.add(new UValue(one));
    }
    status.publish(new UDictionary().with("status_list", new UValue(all)));
  }

  /** Forgets what nobody will ask for. */
  private synchronized void forgetLater(ServedGoal goal) {
    List<ServedGoal> done = new ArrayList<>(chosen(each -> each.current().isEnd()));
    for (ServedGoal each : done.subList(0, Math.max(0, done.size() - MOST_ENDED)))
      goals.remove(each.id);
    LATER.execute(() -> forget(goal));
  }

  private synchronized void forget(ServedGoal goal) {
    goals.remove(goal.id, goal);
  }

  @Override
  public void close() {
    List<ServedGoal> left;
    synchronized (this) {
      if (closed) return;
      closed = true;
      left = List.copyOf(goals.values());
    }
    left.forEach(each -> each.end(GoalStatus.ABORTED, Templates.of(type.result())));
    closeParts();
  }

  private void closeParts() {
    services.forEach(ServiceServer::close);
    feedback.close();
    status.close();
  }

  private final class ServedGoal implements Goal {
    final UUID id;
    final UDictionary request;
    final long accepted = actions.node().now();
    final CompletableFuture<UDictionary> outcome = new CompletableFuture<>();
    private GoalStatus current = GoalStatus.UNKNOWN;

    ServedGoal(UUID id, UDictionary request) {
      this.id = id;
      this.request = request;
    }

    GoalStatus current() {
      synchronized (TwoActionServer.this) {
        return current;
      }
    }

    private boolean become(GoalStatus next, Predicate<GoalStatus> possible) {
      synchronized (TwoActionServer.this) {
        if (!possible.test(current)) return false;
        current = next;
        tell();
        return true;
      }
    }

    /** The goal is pursued from now on, if it has not ended at once. */
    void begin() {
      become(GoalStatus.EXECUTING, now -> now == GoalStatus.UNKNOWN);
    }

    /** Whether it is being given up. */
    boolean cancel() {
      boolean isNew = become(GoalStatus.CANCELING, now -> now == GoalStatus.EXECUTING);
      if (isNew) handler.cancel(this);
      return isNew || current() == GoalStatus.CANCELING;
    }

    UValue stamp() {
      return Templates.time(accepted);
    }

    UDictionary info() {
      return new UDictionary().with("goal_id", GoalIds.message(id)).with("stamp", stamp());
    }

    @Override
    public UDictionary request() {
      return request;
    }

    @Override
    public void feedback(UDictionary told) {
      if (current().isEnd()) return;
      feedback.publish(
          new UDictionary().with("goal_id", GoalIds.message(id)).with("feedback", told));
    }

    @Override
    public void end(GoalStatus wanted, UDictionary result) {
      results.encode(result);
      synchronized (TwoActionServer.this) {
        boolean isAsked = wanted != GoalStatus.CANCELED || current == GoalStatus.CANCELING;
        GoalStatus end = isAsked ? wanted : GoalStatus.ABORTED;
        if (!become(end, now -> !now.isEnd())) return;
        forgetLater(this);
      }
      outcome.complete(ended(current(), result));
    }
  }
}
