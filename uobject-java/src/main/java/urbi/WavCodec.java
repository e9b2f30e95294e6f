package urbi;

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

  /** A file of the samples that the sound has. */
  static byte[] encode(USound sound) {
    byte[] samples = sound.getData();
    int frame = sound.getChannels() * sound.getSampleSize() / 8;
    boolean floats = sound.getSampleFormat() == USoundSampleFormat.SAMPLE_FLOAT;
    ByteBuffer out =
        ByteBuffer.allocate(Math.addExact(HEADER, samples.length)).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(RIFF).putInt(HEADER - 8 + samples.length).putInt(WAVE);
    out.putInt(FMT).putInt(16);
    out.putShort((short) (floats ? FLOATS : INTEGERS)).putShort((short) sound.getChannels());
    out.putInt(sound.getRate()).putInt(sound.getRate() * frame);
    out.putShort((short) frame).putShort((short) sound.getSampleSize());
    out.putInt(DATA).putInt(samples.length).put(samples);
    return out.array();
  }

  /** The raw sound in a file. */
  static USound decode(byte[] file) {
    ByteBuffer in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    try {
      if (in.getInt() != RIFF || in.getInt() == 0 || in.getInt() != WAVE) {
        throw new UConversionException("no WAV file: it does not start as one");
      }
      return chunks(in);
    } catch (BufferUnderflowException | IllegalArgumentException e) {
      throw new UConversionException("a WAV file ends too early", e);
    }
  }

  private static USound chunks(ByteBuffer in) {
    USound sound = null;
    while (true) {
      int name = in.getInt();
      long size = in.getInt() & 0xffffffffL;
      int start = in.position();
      if (name == FMT) {
        sound = format(in);
      } else if (name == DATA) {
        if (sound == null) {
          throw new UConversionException("a WAV file has data before their format");
        }
        int end = (int) Math.min(in.limit(), start + size);
        sound.setData(Arrays.copyOfRange(in.array(), start, end));
        return sound;
      }
      in.position(Math.toIntExact(Math.min(in.limit() + 1L, start + size + size % 2)));
    }
  }

  private static USound format(ByteBuffer in) {
    int code = in.getShort() & 0xffff;
    USound sound = new USound();
    sound.setSoundFormat(USoundFormat.SOUND_RAW);
    sound.setChannels(in.getShort() & 0xffff);
    sound.setRate(in.getInt());
    in.getInt();
    in.getShort();
    int size = in.getShort() & 0xffff;
    sound.setSampleSize(size);
    if (code == EXTENSIBLE) {
      in.getShort();
      in.getShort();
      in.getInt();
      code = in.getShort() & 0xffff;
    }
    sound.setSampleFormat(
        switch (code) {
          case INTEGERS ->
              size <= 8 ? USoundSampleFormat.SAMPLE_UNSIGNED : USoundSampleFormat.SAMPLE_SIGNED;
          case FLOATS -> USoundSampleFormat.SAMPLE_FLOAT;
          default -> throw new UConversionException("a WAV file is compressed: format " + code);
        });
    return sound;
  }
}
