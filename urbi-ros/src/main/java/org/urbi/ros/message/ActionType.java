package org.urbi.ros.message;

/**
 * An action of ROS 2, with what is derived from it: two services of its own and a topic. To cancel
 * and to tell the status it uses those of {@code action_msgs}.
 *
 * @param whole goal, result and feedback as fields of one message, as ROS 2 describes an action
 */
public record ActionType(
    MessageType whole,
    MessageType goal,
    MessageType result,
    MessageType feedback,
    ServiceType sendGoal,
    ServiceType getResult,
    MessageType feedbackMessage) {
  public TypeName name() {
    return whole.name();
  }
}
