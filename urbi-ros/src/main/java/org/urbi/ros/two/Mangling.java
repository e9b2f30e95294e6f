package org.urbi.ros.two;

import org.urbi.ros.message.TypeName;

/** Names of ROS 2 as DDS has them. */
final class Mangling {
  private static final String TOPIC = "rt";
  private static final String REQUEST = "rq";
  private static final String REPLY = "rr";
  private static final String REQUEST_END = "Request";
  private static final String REPLY_END = "Reply";
  private static final String DDS = "::dds_::";

  private Mangling() {}

  static String topic(String name) {
    return TOPIC + name;
  }

  static String request(String service) {
    return REQUEST + service + REQUEST_END;
  }

  static String reply(String service) {
    return REPLY + service + REPLY_END;
  }

  /** {@code std_msgs::msg::dds_::String_}. */
  static String type(TypeName name) {
    String[] parts = name.toString().split("/");
    return parts[0] + "::" + parts[1] + DDS + parts[2] + "_";
  }

  /** The name of a topic of ROS, empty if it is none. */
  static String topicOf(String dds) {
    return dds.startsWith(TOPIC + "/") ? dds.substring(TOPIC.length()) : "";
  }

  /** The name of the service whose requests the topic has; empty if it is not such a topic. */
  static String serviceOf(String dds) {
    return dds.startsWith(REQUEST + "/") && dds.endsWith(REQUEST_END)
        ? dds.substring(REQUEST.length(), dds.length() - REQUEST_END.length())
        : "";
  }

  /** {@code std_msgs/msg/String}; names that are not of ROS remain as they are. */
  static String typeOf(String dds) {
    int at = dds.indexOf(DDS);
    if (at < 0 || !dds.endsWith("_")) return dds;
    return dds.substring(0, at).replace("::", "/")
        + "/"
        + dds.substring(at + DDS.length(), dds.length() - 1);
  }

  /** {@code std_srvs/srv/Trigger}, of the type of its requests. */
  static String serviceTypeOf(String dds) {
    String type = typeOf(dds);
    return type.endsWith("_Request")
        ? type.substring(0, type.length() - "_Request".length())
        : type;
  }
}
