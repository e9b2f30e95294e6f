package urbi.wire;

import org.jspecify.annotations.Nullable;

/** The other side violates the protocol. */
public class WireException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public WireException(@Nullable String message) {
    super(message);
  }
}
