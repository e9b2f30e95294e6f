package org.urbi.ros.codec;

/** Bytes that are no message of their type. */
public class CodecException extends RuntimeException {
  public CodecException(String message) {
    super(message);
  }
}
