package urbi;

/** Converts sounds: format, number of channels, rate, size and meaning of samples. */
final class SoundConversion {
  private SoundConversion() {}

  static void convert(USound source, USound destination) {
    USoundFormat format = destination.getSoundFormat();
    if (format != USoundFormat.SOUND_RAW && format != USoundFormat.SOUND_WAV) {
      throw new UConversionException(
          "sounds are converted to raw and wav, not to " + format.format_string());
    }
    USound raw = raw(source);
    SampleCoding from = SampleCoding.of(raw);
    int size = or(destination.getSampleSize(), raw.getSampleSize());
    USoundSampleFormat meaning = destination.getSampleFormat();
    if (format == USoundFormat.SOUND_WAV && meaning != USoundSampleFormat.SAMPLE_FLOAT) {
      // Files have it so: bytes without a sign, and all else with one.
      meaning = size <= 8 ? USoundSampleFormat.SAMPLE_UNSIGNED : USoundSampleFormat.SAMPLE_SIGNED;
    } else if (meaning == null) {
      meaning =
          from.meaning() == USoundSampleFormat.SAMPLE_FLOAT && size < 32
              ? USoundSampleFormat.SAMPLE_SIGNED
              : from.meaning();
    }
    SampleCoding to = new SampleCoding(size, meaning);
    int channels = or(destination.getChannels(), raw.getChannels());
    int rate = or(destination.getRate(), raw.getRate());
    byte[] data;
    if (from.equals(to) && channels == raw.getChannels() && rate == raw.getRate()) {
      data = raw.getData().clone();
    } else {
      double[][] samples = mixed(samples(raw, from), channels);
      data = bytes(resampled(samples, raw.getRate(), rate), to);
    }
    destination.setChannels(channels);
    destination.setRate(rate);
    destination.setSampleSize(size);
    destination.setSampleFormat(meaning);
    destination.setData(data);
    if (format == USoundFormat.SOUND_WAV) {
      destination.setData(WavCodec.encode(destination));
    }
  }

  private static int or(int wanted, int otherwise) {
    return wanted == 0 ? otherwise : wanted;
  }

  private static USound raw(USound source) {
    USound raw =
        switch (source.getSoundFormat()) {
          case SOUND_RAW -> source;
          case SOUND_WAV -> WavCodec.decode(source.getData());
          default ->
              throw new UConversionException(
                  "sounds are converted from raw and wav, not from " + source.format_string());
        };
    if (raw.getChannels() <= 0 || raw.getRate() <= 0 || raw.getSampleSize() <= 0) {
      throw new UConversionException("a sound does not say what it is: " + raw);
    }
    return raw;
  }

  /** One array for each channel. */
  private static double[][] samples(USound sound, SampleCoding coding) {
    int channels = sound.getChannels();
    int frames = sound.getSize() / (coding.bytes() * channels);
    double[][] samples = new double[channels][frames];
    int at = 0;
    for (int i = 0; i < frames; i++) {
      for (double[] channel : samples) {
        channel[i] = coding.read(sound.getData(), at);
        at += coding.bytes();
      }
    }
    return samples;
  }

  /** To one channel: the mean; to more: those that there are, over and over. */
  private static double[][] mixed(double[][] samples, int channels) {
    if (channels == samples.length) {
      return samples;
    }
    double[][] result = new double[channels][];
    if (channels == 1) {
      double[] mean = new double[samples[0].length];
      for (double[] channel : samples) {
        for (int i = 0; i < mean.length; i++) {
          mean[i] += channel[i] / samples.length;
        }
      }
      result[0] = mean;
    } else {
      for (int i = 0; i < channels; i++) {
        result[i] = samples[i % samples.length];
      }
    }
    return result;
  }

  /** Samples at another rate, on the straight lines between those that there are. */
  private static double[][] resampled(double[][] samples, int rate, int newRate) {
    int frames = samples[0].length;
    if (rate == newRate || frames == 0) {
      return samples;
    }
    int newFrames = Math.toIntExact(Math.round((double) frames * newRate / rate));
    double[][] result = new double[samples.length][newFrames];
    for (int i = 0; i < newFrames; i++) {
      double position = (double) i * rate / newRate;
      int before = Math.min((int) position, frames - 1);
      int after = Math.min(before + 1, frames - 1);
      double share = position - before;
      for (int channel = 0; channel < samples.length; channel++) {
        double[] old = samples[channel];
        result[channel][i] = old[before] + (old[after] - old[before]) * Math.min(share, 1);
      }
    }
    return result;
  }

  private static byte[] bytes(double[][] samples, SampleCoding coding) {
    int frames = samples[0].length;
    byte[] data = new byte[Math.multiplyExact(frames * samples.length, coding.bytes())];
    int at = 0;
    for (int i = 0; i < frames; i++) {
      for (double[] channel : samples) {
        coding.write(channel[i], data, at);
        at += coding.bytes();
      }
    }
    return data;
  }
}
