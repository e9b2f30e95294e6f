package urbi.media;

import org.jspecify.annotations.Nullable;

/**
 * A sound in any format.
 *
 * @param channels 1 for mono, 2 for stereo; 0 if that is not known
 * @param rate samples in a second; 0 if that is not known
 * @param sampleSize bits; 0 if that is not known
 * @param samples what the bits mean; null if that is not known
 * @param data not copied
 */
public record SoundData(
    SoundFormat format,
    int channels,
    int rate,
    int sampleSize,
    @Nullable SampleFormat samples,
    byte[] data) {
  /**
   * The same sound as another one is: its channels, rate, sample size and sample format, and this
   * one's where those are not known.
   *
   * @param wanted its data do not matter
   * @return has data of its own
   * @throws MediaException if the data are no such sound, or a format is not supported
   */
  public SoundData converted(SoundData wanted) {
    return SoundConversion.convert(this, wanted);
  }

  @Override
  public String toString() {
    return format.keyword()
        + " "
        + channels
        + " "
        + rate
        + " "
        + sampleSize
        + " "
        + SampleFormat.code(samples)
        + " ("
        + data.length
        + " bytes)";
  }
}
