package urbi.media;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/** WAV files with uncompressed samples. */
final class WavCodec {
  private static final int RIFF = 0x46464952;
  private static final int WAVE = 0x45564157;
  private static final int FMT = 0x20746d66;
  private static final int DATA = 0x61746164;
  private static final int HEADER = 44;
  private static final int INTEGERS = 1;
  private static final int FLOATS = 3;
  private static final int EXTENSIBLE = 0xfffe;

  private WavCodec() {}

  /** A file of the samples that the recording has. */
  static SoundData encode(SoundData sound) {
    byte[] samples = sound.data();
    int frame = sound.channels() * sound.sampleSize() / 8;
    boolean floats = sound.samples() == SampleFormat.FLOAT;
    ByteBuffer out =
        ByteBuffer.allocate(Math.addExact(HEADER, samples.length)).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(RIFF).putInt(HEADER - 8 + samples.length).putInt(WAVE);
    out.putInt(FMT).putInt(16);
    out.putShort((short) (floats ? FLOATS : INTEGERS)).putShort((short) sound.channels());
    out.putInt(sound.rate()).putInt(sound.rate() * frame);
    out.putShort((short) frame).putShort((short) sound.sampleSize());
    out.putInt(DATA).putInt(samples.length).put(samples);
    return new SoundData(
        SoundFormat.WAV,
        sound.channels(),
        sound.rate(),
        sound.sampleSize(),
        sound.samples(),
        out.array());
  }

  /** The raw sound in a file. */
  static SoundData decode(byte[] file) {
    ByteBuffer in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    try {
      if (in.getInt() != RIFF || in.getInt() == 0 || in.getInt() != WAVE) {
        throw new MediaException("no WAV file: it does not start as one");
      }
      return chunks(in);
    } catch (BufferUnderflowException | IllegalArgumentException e) {
      throw new MediaException("a WAV file ends too early", e);
    }
  }

  private static SoundData chunks(ByteBuffer in) {
    SoundData format = null;
    while (true) {
      int name = in.getInt();
      long size = in.getInt() & 0xffffffffL;
      int start = in.position();
      if (name == FMT) {
        format = format(in);
      } else if (name == DATA) {
        if (format == null) {
          throw new MediaException("a WAV file has data before their format");
        }
        int end = (int) Math.min(in.limit(), start + size);
        byte[] data = Arrays.copyOfRange(in.array(), start, end);
        return new SoundData(
            SoundFormat.RAW,
            format.channels(),
            format.rate(),
            format.sampleSize(),
            format.samples(),
            data);
      }
      in.position(Math.toIntExact(Math.min(in.limit() + 1L, start + size + size % 2)));
    }
  }

  /** A recording that has no data yet. */
  private static SoundData format(ByteBuffer in) {
    int code = in.getShort() & 0xffff;
    int channels = in.getShort() & 0xffff;
    int rate = in.getInt();
    in.getInt();
    in.getShort();
    int size = in.getShort() & 0xffff;
    if (code == EXTENSIBLE) {
      in.getShort();
      in.getShort();
      in.getInt();
      code = in.getShort() & 0xffff;
    }
    SampleFormat samples =
        switch (code) {
          case INTEGERS -> size <= 8 ? SampleFormat.UNSIGNED : SampleFormat.SIGNED;
          case FLOATS -> SampleFormat.FLOAT;
          default -> throw new MediaException("a WAV file is compressed: format " + code);
        };
    return new SoundData(SoundFormat.RAW, channels, rate, size, samples, new byte[0]);
  }
}
