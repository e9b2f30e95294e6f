package urbi;

import java.io.File;
import java.io.IOException;
import java.util.Arrays;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.UnsupportedAudioFileException;

/** Helper methods for programs that record and play sounds. */
public final class SoundUtilities {
  private static final int BLOCK = 2048;

  private static volatile float sampleRate = 8000;
  private static volatile int sampleSize = 8;
  private static volatile int channels = 1;
  private static volatile boolean signed = true;
  private static volatile boolean bigEndian;

  private SoundUtilities() {}

  /** Samples in a second. */
  public static float getSampleRate() {
    return sampleRate;
  }

  public static void setSampleRate(float hertz) {
    sampleRate = hertz;
  }

  /** Bits of a sample. */
  public static int getSampleSizeInBits() {
    return sampleSize;
  }

  public static void setSampleSizeInBits(int bits) {
    sampleSize = bits;
  }

  /** 1 for mono, 2 for stereo. */
  public static int getChannels() {
    return channels;
  }

  public static void setChannels(int number) {
    channels = number;
  }

  public static boolean getSigned() {
    return signed;
  }

  public static void setSigned(boolean on) {
    signed = on;
  }

  public static boolean getBigEndian() {
    return bigEndian;
  }

  public static void setBigEndian(boolean on) {
    bigEndian = on;
  }

  /** All these together. */
  public static AudioFormat getFormat() {
    return new AudioFormat(sampleRate, sampleSize, channels, signed, bigEndian);
  }

  /**
   * Has the device {@code speaker} of a server play a file, block by block.
   *
   * @return 0, or -1 if it is no file with sound
   * @throws IOException if it cannot be read
   */
  public static int sendSound(String file, UClient client) throws IOException {
    try (AudioInputStream in = AudioSystem.getAudioInputStream(new File(file))) {
      AudioFormat format = in.getFormat();
      String header =
          " raw "
              + format.getChannels()
              + " "
              + (int) format.getSampleRate()
              + " "
              + format.getSampleSizeInBits()
              + " "
              + (format.getEncoding().equals(AudioFormat.Encoding.PCM_UNSIGNED) ? 2 : 1)
              + ";";
      byte[] block = new byte[BLOCK];
      for (int size = in.read(block); size >= 0; size = in.read(block)) {
        byte[] statement = Arrays.copyOf(block, size + 2);
        statement[size] = ';';
        statement[size + 1] = '\n';
        client.sendBin(statement, "speaker.val = BIN " + size + header);
      }
      return 0;
    } catch (UnsupportedAudioFileException e) {
      return -1;
    }
  }
}
