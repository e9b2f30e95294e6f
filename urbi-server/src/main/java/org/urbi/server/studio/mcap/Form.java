package org.urbi.server.studio.mcap;

import org.urbi.server.studio.foxglove.Topic;

/**
 * How the messages of a channel are written.
 *
 * @param schemaName of their type
 * @param schemaEncoding the language of the schema
 * @param schema its text
 * @param messageEncoding how the bytes of a message are to be read
 */
record Form(String schemaName, String schemaEncoding, String schema, String messageEncoding) {
  /** JSON, which can tell any value. */
  static Form json(Topic topic) {
    return new Form(topic.schemaName(), "jsonschema", topic.schema(), "json");
  }

  /** A message of ROS 2. */
  static Form ros(String type, String definition) {
    return new Form(type, "ros2msg", definition, "cdr");
  }
}
