package org.urbi.ros.graph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import urbi.UDictionary;

class SentGoalTest {
  private final List<GoalStatus> told = new ArrayList<>();

  private final SentGoal goal =
      new SentGoal(
          new ActionClient.Listener() {
            @Override
            public void feedback(UDictionary feedback) {}

            @Override
            public void status(GoalStatus status) {
              told.add(status);
            }
          }) {
        @Override
        public CompletableFuture<Boolean> cancel() {
          throw new UnsupportedOperationException();
        }
      };

  @Test
  void whatIsOldIsNotTold() {
    assertTrue(goal.told(GoalStatus.ACCEPTED));
    assertTrue(goal.told(GoalStatus.EXECUTING));
    assertFalse(goal.told(GoalStatus.ACCEPTED));
    assertFalse(goal.told(GoalStatus.EXECUTING));
    assertFalse(goal.told(GoalStatus.SUCCEEDED), "that comes with the result");
    assertEquals(List.of(GoalStatus.ACCEPTED, GoalStatus.EXECUTING), told);
  }

  /** The topic of statuses may overtake the answer that accepts the goal. */
  @Test
  void aGoalIsAcceptedBeforeItIsPursued() {
    assertTrue(goal.told(GoalStatus.CANCELING));
    assertFalse(goal.told(GoalStatus.ACCEPTED));
    assertFalse(goal.told(GoalStatus.EXECUTING));
    assertEquals(List.of(GoalStatus.ACCEPTED, GoalStatus.CANCELING), told);
  }
}
