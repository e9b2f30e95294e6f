package org.urbi.ros.message;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * What ROS derives from services and actions: the messages that are really sent, each described as
 * if there were a file of it.
 */
final class Derived {
  private static final TypeName TIME = TypeName.message("builtin_interfaces", "Time");
  private static final TypeName UUID = TypeName.message("unique_identifier_msgs", "UUID");
  private static final TypeName EVENT_INFO = TypeName.message("service_msgs", "ServiceEventInfo");

  private Derived() {}

  private static MessageDefinition message(TypeName name, Field... fields) {
    return new MessageDefinition(name, Dialect.ROS_2, List.of(fields), List.of(), "");
  }

  private static Field field(String name, TypeName type) {
    return new Field(name, new FieldType.Nested(type), null);
  }

  private static Field field(String name, Primitive type) {
    return new Field(name, new FieldType.Basic(type), null);
  }

  private static Field atMostOne(String name, TypeName type) {
    return new Field(
        name, new FieldType.Array(new FieldType.Nested(type), FieldType.Length.BOUNDED, 1), null);
  }

  /** A service of ROS 2 as one message. */
  static MessageDefinition service(TypeName name) {
    return message(
        name,
        field("request_message", name.derived("_Request")),
        field("response_message", name.derived("_Response")),
        field("event_message", name.derived("_Event")));
  }

  /** What those are told who watch a service of ROS 2. */
  static MessageDefinition event(TypeName service) {
    return message(
        service.derived("_Event"),
        field("info", EVENT_INFO),
        atMostOne("request", service.derived("_Request")),
        atMostOne("response", service.derived("_Response")));
  }

  /** An action of ROS 2 as one message. */
  static MessageDefinition action(TypeName name) {
    return message(
        name,
        field("goal", name.derived("_Goal")),
        field("result", name.derived("_Result")),
        field("feedback", name.derived("_Feedback")),
        field("send_goal_service", name.derived("_SendGoal")),
        field("get_result_service", name.derived("_GetResult")),
        field("feedback_message", name.derived("_FeedbackMessage")));
  }

  /** What an action of ROS 1 consists of: the names of its goal, result and feedback. */
  static List<TypeName> messagesOfOne(TypeName action) {
    return Stream.of("Goal", "Result", "Feedback")
        .map(each -> TypeName.message(action.pack(), action.name() + each))
        .toList();
  }

  /** The messages in which they travel. */
  static List<MessageDefinition> topicsOfOne(TypeName action) {
    return List.of(
        topicOfOne(action, "Goal", "actionlib_msgs/GoalID goal_id"),
        topicOfOne(action, "Result", "actionlib_msgs/GoalStatus status"),
        topicOfOne(action, "Feedback", "actionlib_msgs/GoalStatus status"));
  }

  private static MessageDefinition topicOfOne(TypeName action, String what, String whose) {
    String text =
        "Header header\n%s\n%s%s %s\n"
            .formatted(whose, action.name(), what, what.toLowerCase(Locale.ROOT));
    return DefinitionReader.read(
        TypeName.message(action.pack(), action.name() + "Action" + what), Dialect.ROS_1, text);
  }

  /** The messages of the services of an action, and that of its feedback. */
  static List<MessageDefinition> ofAction(TypeName name) {
    TypeName send = name.derived("_SendGoal");
    TypeName get = name.derived("_GetResult");
    return List.of(
        message(
            send.derived("_Request"), field("goal_id", UUID), field("goal", name.derived("_Goal"))),
        message(send.derived("_Response"), field("accepted", Primitive.BOOL), field("stamp", TIME)),
        service(send),
        event(send),
        message(get.derived("_Request"), field("goal_id", UUID)),
        message(
            get.derived("_Response"),
            field("status", Primitive.INT8),
            field("result", name.derived("_Result"))),
        service(get),
        event(get),
        message(
            name.derived("_FeedbackMessage"),
            field("goal_id", UUID),
            field("feedback", name.derived("_Feedback"))));
  }
}
