package org.urbi.ros.codec;

/** Bytes that are no message of their type. */
public class CodecException extends RuntimeException {
  public CodecException(String message) {
    super(message);
  }

  /** It tells of bytes that others have sent, maybe many thousand times a second. */
  @Override
  public synchronized Throwable fillInStackTrace() {
    return this;
  }
}
