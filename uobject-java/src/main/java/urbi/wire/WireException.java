package urbi.wire;

import org.jspecify.annotations.Nullable;

/** The other side does not keep to the protocol. */
public class WireException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public WireException(@Nullable String message) {
    super(message);
  }
}
