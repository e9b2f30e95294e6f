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
   * This sound with the channels, the rate, the sample size and the sample format of another one;
   * what is not known of that one remains.
   *
   * @param wanted the other sound, whose data do not matter
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
