package urbi;

/** A value cannot be converted to the requested type. */
public class UCastException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public UCastException(String message) {
    super(message);
  }

  UCastException(String message, Throwable cause) {
    super(message, cause);
  }

  static UCastException to(String type, UValue from) {
    return new UCastException("invalid cast to " + type + " from " + from.brief());
  }
}
