package org.urbi.ros.bridge;

/** What a client sends, and cannot be done. The message says to people what to do. */
class BridgeException extends RuntimeException {
  BridgeException(String message) {
    super(message);
  }

  /** No stack trace: people do not want to know where in this module it was thrown. */
  @Override
  public synchronized Throwable fillInStackTrace() {
    return this;
  }
}
