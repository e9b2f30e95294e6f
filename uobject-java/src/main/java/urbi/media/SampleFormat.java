package urbi.media;

import org.jspecify.annotations.Nullable;

/** What the bits of a sample mean. */
public enum SampleFormat {
  SIGNED(1),
  UNSIGNED(2),
  /** IEEE 754. */
  FLOAT(3);

  private final int code;

  SampleFormat(int code) {
    this.code = code;
  }

  /** The number that stands for it in the header of a binary; 0 leaves it open. */
  public int code() {
    return code;
  }

  /** The number of a format; that of null is 0. */
  public static int code(@Nullable SampleFormat format) {
    return format == null ? 0 : format.code;
  }
}
