package org.urbi.server.options;

/** Why a program cannot go on, in words for the user, and its exit status. */
public final class Failure extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private static final int FAILED = 1;
  private static final int MISUSED = 2;

  private final int status;

  private Failure(int status, String message) {
    super(message, null, false, false);
    this.status = status;
  }

  /** Something the program needs is not there: status 1. */
  public static Failure of(String message) {
    return new Failure(FAILED, message);
  }

  /** The command line makes no sense: status 2. */
  public static Failure usage(String message) {
    return new Failure(MISUSED, message);
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
