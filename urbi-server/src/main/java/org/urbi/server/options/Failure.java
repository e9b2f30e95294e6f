package org.urbi.server.options;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.jspecify.annotations.Nullable;

/** A program cannot continue: a message for the user, and the exit status. */
public final class Failure extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private static final int FAILED = 1;
  private static final int MISUSED = 2;

  private final int status;

  private Failure(int status, @Nullable String message) {
    super(message, null, false, false);
    this.status = status;
  }

  /** Something that the program needs is missing: status 1. */
  public static Failure of(@Nullable String message) {
    return new Failure(FAILED, message);
  }

  /** The command line makes no sense: status 2. */
  public static Failure usage(@Nullable String message) {
    return new Failure(MISUSED, message);
  }

  /** The system's description of an error with a file. */
  public static String reason(UncheckedIOException failure) {
    IOException cause = requireNonNull(failure.getCause(), "it is made of one");
    return String.valueOf(cause.getMessage());
  }

  /** The exit status of the program. */
  public int status() {
    return status;
  }

  /** Whether to refer the user to the help. */
  public boolean isMisuse() {
    return status == MISUSED;
  }
}
