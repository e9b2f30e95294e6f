package urbi;

import org.jspecify.annotations.Nullable;

/**
 * A client cannot do what it is asked for: no connection, no answer in time, or an error instead.
 */
public class UClientException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public UClientException(String message) {
    super(message);
  }

  public UClientException(@Nullable String message, Throwable cause) {
    super(message, cause);
  }
}
