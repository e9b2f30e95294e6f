package org.urbi.bridge;

/** An exception that C++ code has thrown, with its text. */
public final class NativeException extends IllegalStateException {
  private static final long serialVersionUID = 1;

  NativeException(String message) {
    super(message);
  }

  /** Where the Java code was tells nothing: it was thrown in C++. */
  @Override
  public Throwable fillInStackTrace() {
    return this;
  }
}
