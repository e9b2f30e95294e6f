package org.urbi.ros.codec;

/** Bytes that are no message of their type. */
public class CodecException extends RuntimeException {
  public CodecException(String message) {
    super(message);
  }

  /** No stack trace: others may send such bytes many thousand times a second. */
  @Override
  public synchronized Throwable fillInStackTrace() {
    return this;
  }
}
