package urbi.media;

/**
 * How a sample, from -1 to 1, is kept in bytes, lowest first.
 *
 * @param size in bits: 8, 16, 24 or 32, and 64 for floats
 */
record SampleCoding(int size, SampleFormat meaning) {
  SampleCoding {
    boolean floating = meaning == SampleFormat.FLOAT;
    if (floating ? size != 32 && size != 64 : size % 8 != 0 || size < 8 || size > 32) {
      throw new MediaException("samples of " + size + " bits, " + meaning + ", are not supported");
    }
  }

  /** How a raw sound keeps them; one that does not tell has bytes without a sign, others with. */
  static SampleCoding of(SoundData raw) {
    SampleFormat meaning = raw.samples();
    if (meaning == null) {
      meaning = raw.sampleSize() == 8 ? SampleFormat.UNSIGNED : SampleFormat.SIGNED;
    }
    return new SampleCoding(raw.sampleSize(), meaning);
  }

  int bytes() {
    return size / 8;
  }

  private double scale() {
    return 1L << size - 1;
  }

  double read(byte[] data, int at) {
    long bits = 0;
    for (int i = bytes() - 1; i >= 0; i--) {
      bits = bits << 8 | data[at + i] & 0xff;
    }
    return switch (meaning) {
      case FLOAT -> size == 32 ? Float.intBitsToFloat((int) bits) : Double.longBitsToDouble(bits);
      case SIGNED -> (bits << 64 - size >> 64 - size) / scale();
      case UNSIGNED -> (bits - scale()) / scale();
    };
  }

  void write(double sample, byte[] data, int at) {
    long bits =
        switch (meaning) {
          case FLOAT ->
              size == 32 ? Float.floatToIntBits((float) sample) : Double.doubleToLongBits(sample);
          case SIGNED -> quantized(sample);
          case UNSIGNED -> quantized(sample) + (1L << size - 1);
        };
    for (int i = 0; i < bytes(); i++) {
      data[at + i] = (byte) (bits >> 8 * i);
    }
  }

  private long quantized(double sample) {
    long most = 1L << size - 1;
    return Math.clamp(Math.round(sample * most), -most, most - 1);
  }
}
