package org.urbi.ros.graph;

/** What ROS refuses, or cannot do now. The message says to people what to do. */
public class RosException extends IllegalStateException {
  public RosException(String message) {
    super(message);
  }

  public RosException(String message, Throwable cause) {
    super(message, cause);
  }

  /** No stack trace: people do not want to know where in this module it was thrown. */
  @Override
  public synchronized Throwable fillInStackTrace() {
    return this;
  }
}
