package urbi;

import org.jspecify.annotations.Nullable;

/** An image or sound cannot be converted: its data are not what they should be, or the format. */
public class UConversionException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public UConversionException(String message) {
    super(message);
  }

  UConversionException(@Nullable String message, Throwable cause) {
    super(message, cause);
  }
}
