package urbi.media;

/** An image or sound cannot be converted: its data are not what they should be, or the format. */
public class MediaException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public MediaException(String message) {
    super(message);
  }

  public MediaException(String message, Throwable cause) {
    super(message, cause);
  }
}
