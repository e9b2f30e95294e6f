package org.urbi.server.options;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.jspecify.annotations.Nullable;

/** Why a program cannot go on, in words for the user, and its exit status. */
public final class Failure extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private static final int FAILED = 1;
  private static final int MISUSED = 2;

  private final int status;

  private Failure(int status, @Nullable String message) {
    super(message, null, false, false);
    this.status = status;
  }

  /** Something the program needs is not there: status 1. */
  public static Failure of(@Nullable String message) {
    return new Failure(FAILED, message);
  }

  /** The command line makes no sense: status 2. */
  public static Failure usage(@Nullable String message) {
    return new Failure(MISUSED, message);
  }

  /** What the system says of a file that cannot be used. */
  public static String reason(UncheckedIOException failure) {
    IOException cause = requireNonNull(failure.getCause(), "it is made of one");
    return String.valueOf(cause.getMessage());
  }

  /** The exit status to leave with. */
  public int status() {
    return status;
  }

  /** Whether a look at the help would be useful. */
  public boolean isMisuse() {
    return status == MISUSED;
  }
}
