package org.urbi.server.studio.messages;

/**
 * How the messages of a channel are written.
 *
 * @param schemaName of their type
 * @param schemaEncoding the language of the schema
 * @param schema its text
 * @param messageEncoding how the bytes of a message are to be read
 */
public record Form(
    String schemaName, String schemaEncoding, String schema, String messageEncoding) {
  /** JSON, which can tell any value. */
  public static Form json(Topic topic) {
    return new Form(topic.schemaName(), "jsonschema", topic.schema(), "json");
  }

  /** Messages of ROS 2 where there is a type for what a topic usually tells, else JSON. */
  public static Form rosOrJson(Topic topic) {
    RosType type = RosType.of(topic);
    return type == null ? json(topic) : type.form();
  }

  /** A message of ROS 2. */
  static Form ros(String type, String definition) {
    return new Form(type, "ros2msg", definition, "cdr");
  }
}
