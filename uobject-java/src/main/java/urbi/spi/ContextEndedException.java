package urbi.spi;

/** What a UObject belonged to has ended: its kernel, or the connection to it. */
public final class ContextEndedException extends IllegalStateException {
  private static final long serialVersionUID = 1;

  /** Says so in these words. */
  public ContextEndedException(String message) {
    super(message);
  }
}
