package urbi;

/** What the bits of a sample mean. */
public enum USoundSampleFormat {
  SAMPLE_SIGNED(1),
  SAMPLE_UNSIGNED(2),
  /** IEEE 754. */
  SAMPLE_FLOAT(3);

  private final int code;

  USoundSampleFormat(int code) {
    this.code = code;
  }

  /** The number that stands for it in the header of a binary. */
  public int code() {
    return code;
  }

  /** What a number stands for; null for others, and for 0, which leaves it open. */
  static USoundSampleFormat of(int code) {
    for (USoundSampleFormat format : values()) {
      if (format.code == code) {
        return format;
      }
    }
    return null;
  }
}
