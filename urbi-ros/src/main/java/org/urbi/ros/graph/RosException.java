package org.urbi.ros.graph;

/** What ROS refuses, or cannot do now. The message says to people what to do. */
public class RosException extends RuntimeException {
  public RosException(String message) {
    super(message);
  }

  public RosException(String message, Throwable cause) {
    super(message, cause);
  }
}
