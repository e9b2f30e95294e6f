package urbi.media;

/** Converts sounds: format, number of channels, rate, size and meaning of samples. */
final class SoundConversion {
  private SoundConversion() {}

  static SoundData convert(SoundData source, SoundData wanted) {
    SoundFormat format = wanted.format();
    if (format != SoundFormat.RAW && format != SoundFormat.WAV) {
      throw new MediaException("sounds are converted to raw and wav, not to " + format.keyword());
    }
    SoundData raw = raw(source);
    SampleCoding from = SampleCoding.of(raw);
    int size = or(wanted.sampleSize(), raw.sampleSize());
    SampleFormat meaning = wanted.samples();
    if (format == SoundFormat.WAV && meaning != SampleFormat.FLOAT) {
      // Files have it so: bytes without a sign, and all else with one.
      meaning = size <= 8 ? SampleFormat.UNSIGNED : SampleFormat.SIGNED;
    } else if (meaning == null) {
      meaning =
          from.meaning() == SampleFormat.FLOAT && size < 32 ? SampleFormat.SIGNED : from.meaning();
    }
    SampleCoding to = new SampleCoding(size, meaning);
    int channels = or(wanted.channels(), raw.channels());
    int rate = or(wanted.rate(), raw.rate());
    byte[] data;
    if (from.equals(to) && channels == raw.channels() && rate == raw.rate()) {
      data = raw.data().clone();
    } else {
      double[][] samples = mixed(samples(raw, from), channels);
      data = bytes(resampled(samples, raw.rate(), rate), to);
    }
    SoundData result = new SoundData(format, channels, rate, size, meaning, data);
    return format == SoundFormat.WAV ? WavCodec.encode(result) : result;
  }

  private static int or(int wanted, int otherwise) {
    return wanted == 0 ? otherwise : wanted;
  }

  private static SoundData raw(SoundData source) {
    SoundData raw =
        switch (source.format()) {
          case RAW -> source;
          case WAV -> WavCodec.decode(source.data());
          default ->
              throw new MediaException(
                  "sounds are converted from raw and wav, not from " + source.format().keyword());
        };
    if (raw.channels() <= 0 || raw.rate() <= 0 || raw.sampleSize() <= 0) {
      throw new MediaException("a sound does not say what it is: " + raw);
    }
    return raw;
  }

  /** One array for each channel. */
  private static double[][] samples(SoundData sound, SampleCoding coding) {
    int channels = sound.channels();
    int frames = sound.data().length / (coding.bytes() * channels);
    double[][] samples = new double[channels][frames];
    int at = 0;
    for (int i = 0; i < frames; i++) {
      for (double[] channel : samples) {
        channel[i] = coding.read(sound.data(), at);
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
