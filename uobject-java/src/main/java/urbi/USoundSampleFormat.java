package urbi;

import org.jspecify.annotations.Nullable;
import urbi.media.SampleFormat;

/** What the bits of a sample mean. */
public enum USoundSampleFormat {
  SAMPLE_SIGNED(SampleFormat.SIGNED),
  SAMPLE_UNSIGNED(SampleFormat.UNSIGNED),
  /** IEEE 754. */
  SAMPLE_FLOAT(SampleFormat.FLOAT);

  private final SampleFormat format;

  USoundSampleFormat(SampleFormat format) {
    this.format = format;
  }

  /** The number that stands for it in the header of a binary. */
  public int code() {
    return format.code();
  }

  SampleFormat format() {
    return format;
  }

  /** What a format of samples is called here; null for null. */
  static @Nullable USoundSampleFormat of(@Nullable SampleFormat format) {
    for (USoundSampleFormat each : values()) {
      if (each.format == format) {
        return each;
      }
    }
    return null;
  }

  /** What a number stands for; null for others, and for 0, which leaves it open. */
  static @Nullable USoundSampleFormat of(int code) {
    for (USoundSampleFormat each : values()) {
      if (each.code() == code) {
        return each;
      }
    }
    return null;
  }
}
