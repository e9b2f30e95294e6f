package urbi;

import java.util.Arrays;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A sound (manual, "Using binary types"). Its data are shared, not copied. A number of 0 and a
 * sample format of null mean: not known, or as the source has it.
 */
public final class USound {
  private static final byte[] NOTHING = {};

  private byte[] data = NOTHING;
  private int channels;
  private int rate;
  private int sampleSize;
  private USoundFormat format = USoundFormat.SOUND_UNKNOWN;
  private @Nullable USoundSampleFormat sampleFormat;

  /** A sound that has nothing yet. */
  public USound() {}

  /**
   * @param channels 1 for mono, 2 for stereo
   * @param rate samples in a second
   * @param sampleSize bits
   * @param data not copied
   */
  public USound(
      USoundFormat format,
      int channels,
      int rate,
      int sampleSize,
      @Nullable USoundSampleFormat sampleFormat,
      byte[] data) {
    setSoundFormat(format);
    setChannels(channels);
    setRate(rate);
    setSampleSize(sampleSize);
    setSampleFormat(sampleFormat);
    setData(data);
  }

  /** A copy of a sound, which shares its data. */
  public USound(USound other) {
    this(
        other.format, other.channels, other.rate, other.sampleSize, other.sampleFormat, other.data);
  }

  static USound of(UBinary binary) {
    String header = binary.getMessage();
    USoundFormat format = USoundFormat.parse(BinaryHeaderReader.first(header));
    if (format == USoundFormat.SOUND_UNKNOWN) {
      throw UCastException.to("USound", new UValue(binary));
    }
    var words = new BinaryHeaderReader(header);
    return new USound(
        format,
        words.number(),
        words.number(),
        words.number(),
        USoundSampleFormat.of(words.number()),
        binary.getData());
  }

  String headers() {
    return format.format_string()
        + " "
        + channels
        + " "
        + rate
        + " "
        + sampleSize
        + " "
        + (sampleFormat == null ? 0 : sampleFormat.code());
  }

  /** The bytes; not copied. */
  public byte[] getData() {
    return data;
  }

  /** Sets the bytes; not copied. */
  public void setData(byte[] bytes) {
    data = Objects.requireNonNull(bytes, "data");
  }

  /** Forgets the bytes: whatever else has them keeps them. */
  public void deleteData() {
    data = NOTHING;
  }

  /** How many bytes there are. */
  public int getSize() {
    return data.length;
  }

  /** How many samples are played at the same time. */
  public int getChannels() {
    return channels;
  }

  /** Sets how many samples are played at the same time; the bytes stay. */
  public void setChannels(long number) {
    channels = Math.toIntExact(number);
  }

  /** Samples in a second. */
  public int getRate() {
    return rate;
  }

  /** Sets how many samples there are in a second; the bytes stay. */
  public void setRate(long hertz) {
    rate = Math.toIntExact(hertz);
  }

  /** Bits of a sample. */
  public int getSampleSize() {
    return sampleSize;
  }

  /** Sets the bits of a sample; the bytes stay. */
  public void setSampleSize(long bits) {
    sampleSize = Math.toIntExact(bits);
  }

  public USoundFormat getSoundFormat() {
    return format;
  }

  public void setSoundFormat(USoundFormat other) {
    format = Objects.requireNonNull(other, "format");
  }

  /** What the bits of a sample mean; null when that is not known. */
  public @Nullable USoundSampleFormat getSampleFormat() {
    return sampleFormat;
  }

  public void setSampleFormat(@Nullable USoundSampleFormat other) {
    sampleFormat = other;
  }

  /** The format's name. */
  public String format_string() {
    return format.format_string();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof USound that
        && headers().equals(that.headers())
        && Arrays.equals(data, that.data);
  }

  @Override
  public int hashCode() {
    return Objects.hash(headers(), Arrays.hashCode(data));
  }

  /** What it is, without the data. */
  @Override
  public String toString() {
    return headers() + " (" + data.length + " bytes)";
  }
}
