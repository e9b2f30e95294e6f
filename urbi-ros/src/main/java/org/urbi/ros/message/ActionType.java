package org.urbi.ros.message;

/** An action: what is wanted, what comes of it, and how far it is. */
public sealed interface ActionType {
  TypeName name();

  MessageType goal();

  MessageType result();

  MessageType feedback();

  /** An action of ROS 1, whose goals, results and feedbacks travel in messages of three topics. */
  record One(
      TypeName name,
      MessageType goal,
      MessageType result,
      MessageType feedback,
      MessageType goalMessage,
      MessageType resultMessage,
      MessageType feedbackMessage)
      implements ActionType {}

  /**
   * An action of ROS 2, with what is derived from it: two services of its own and a topic. To
   * cancel and to tell the status it uses those of {@code action_msgs}.
   *
   * @param whole goal, result and feedback as fields of one message, as ROS 2 describes an action
   */
  record Two(
      MessageType whole,
      MessageType goal,
      MessageType result,
      MessageType feedback,
      ServiceType sendGoal,
      ServiceType getResult,
      MessageType feedbackMessage)
      implements ActionType {
    @Override
    public TypeName name() {
      return whole.name();
    }
  }
}
