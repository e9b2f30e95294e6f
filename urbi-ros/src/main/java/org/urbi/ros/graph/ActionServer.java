package org.urbi.ros.graph;

import java.util.concurrent.CompletionStage;
import org.urbi.ros.message.ActionType;
import urbi.UDictionary;

/** An action that this node offers. */
public interface ActionServer extends AutoCloseable {
  /** What pursues the goals; called by threads of the network. */
  interface Handler {
    /**
     * A goal has come.
     *
     * @return whether it is accepted, and pursued from now on; it is refused if that fails
     */
    CompletionStage<Boolean> goal(Goal goal);

    /** Somebody wants a goal to be given up; it may end otherwise all the same. */
    void cancel(Goal goal);
  }

  /** A goal that somebody has sent. */
  interface Goal {
    /** What is wanted. */
    UDictionary request();

    /**
     * Tells how far it is; without effect when the goal has ended.
     *
     * @throws org.urbi.ros.message.ValueException if it is not of the type
     */
    void feedback(UDictionary feedback);

    /**
     * Ends it; without effect when it has ended. What was given up that nobody wanted to be given
     * up is told as aborted.
     *
     * @param status an end
     * @throws org.urbi.ros.message.ValueException if the result is not of the type; the goal has
     *     not ended then
     */
    void end(GoalStatus status, UDictionary result);
  }

  /** The full name of the action. */
  String action();

  ActionType type();

  /** Ends the action. Goals that have not ended are aborted. */
  @Override
  void close();
}
