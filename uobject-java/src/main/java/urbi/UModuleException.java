package urbi;

import org.jspecify.annotations.Nullable;

/** A module cannot be loaded; the message says which and why. */
public class UModuleException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public UModuleException(@Nullable String message, Throwable cause) {
    super(message, cause);
  }

  public UModuleException(String message) {
    super(message);
  }
}
