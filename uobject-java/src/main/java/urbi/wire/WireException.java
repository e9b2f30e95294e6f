package urbi.wire;

/** The other side does not keep to the protocol. */
public class WireException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public WireException(String message) {
    super(message);
  }
}
