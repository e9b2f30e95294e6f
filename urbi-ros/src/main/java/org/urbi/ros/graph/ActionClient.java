package org.urbi.ros.graph;

import java.util.concurrent.CompletableFuture;
import org.urbi.ros.message.ActionType;
import urbi.UDictionary;

/** What has another node pursue goals. */
public interface ActionClient extends AutoCloseable {
  /** What becomes of a goal; called by threads of the network. */
  interface Listener {
    /** How far it is. */
    default void feedback(UDictionary feedback) {}

    /** What the server says of the goal, while it has not ended. */
    default void status(GoalStatus status) {}
  }

  /**
   * How a goal has ended.
   *
   * @param result what there is of it, also if the goal was not reached
   */
  record Outcome(GoalStatus status, UDictionary result) {}

  /** A goal that was sent. */
  interface Goal {
    /** Done when the server has accepted the goal; fails if it refuses it, or goes. */
    CompletableFuture<Void> accepted();

    /** How the goal has ended; fails if it was refused, or the server goes. */
    CompletableFuture<Outcome> outcome();

    /**
     * Asks the server to give the goal up, as soon as that has accepted it.
     *
     * @return whether it does, or the goal has ended already; fails if the goal was refused, or the
     *     server goes
     */
    CompletableFuture<Boolean> cancel();
  }

  /** The full name of the action. */
  String action();

  ActionType type();

  /**
   * Sends a goal.
   *
   * @throws org.urbi.ros.message.ValueException if it is not of the type
   */
  Goal send(UDictionary goal, Listener listener);

  /** Ends listening. The server goes on with the goals that it has. */
  @Override
  void close();
}
