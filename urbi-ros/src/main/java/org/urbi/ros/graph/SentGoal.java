package org.urbi.ros.graph;

import java.util.concurrent.CompletableFuture;
import urbi.UDictionary;

/** A goal that was sent, and what is known of it. */
public abstract class SentGoal implements ActionClient.Goal {
  private final ActionClient.Listener listener;
  private final CompletableFuture<Void> accepted = new CompletableFuture<>();
  private final CompletableFuture<ActionClient.Outcome> outcome = new CompletableFuture<>();
  private GoalStatus last = GoalStatus.UNKNOWN;

  protected SentGoal(ActionClient.Listener listener) {
    this.listener = listener;
  }

  /** The goal was refused, or nobody is there any more who would tell of it. */
  public void fail(Throwable reason) {
    accepted.completeExceptionally(reason);
    outcome.completeExceptionally(reason);
  }

  /** The server has accepted it. */
  public final void accept() {
    accepted.complete(null);
  }

  /** The goal has ended. */
  public final void end(ActionClient.Outcome how) {
    outcome.complete(how);
  }

  /** The server tells how far it is. */
  public final void feedback(UDictionary told) {
    listener.feedback(told);
  }

  /**
   * The server tells its status. What comes by another way may be older, or later than what follows
   * it: no goal does anything before it is accepted. How it ends is told with the result.
   *
   * @return whether that is new
   */
  public final boolean told(GoalStatus now) {
    GoalStatus before;
    synchronized (this) {
      before = last;
      if (now.isEnd() || now.compareTo(before) <= 0) return false;
      last = now;
    }
    if (before == GoalStatus.UNKNOWN && now != GoalStatus.ACCEPTED)
      listener.status(GoalStatus.ACCEPTED);
    listener.status(now);
    return true;
  }

  @Override
  public final CompletableFuture<Void> accepted() {
    return accepted;
  }

  @Override
  public final CompletableFuture<ActionClient.Outcome> outcome() {
    return outcome;
  }
}
