package org.urbi.ros.message;

/**
 * A service: what is asked, what is answered.
 *
 * @param whole request, response and event as fields of one message, as ROS 2 describes a service
 */
public record ServiceType(MessageType whole, MessageType request, MessageType response) {
  public TypeName name() {
    return whole.name();
  }
}
