package org.urbi.server.tools;

import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.SourceDataLine;
import org.jspecify.annotations.Nullable;
import org.urbi.server.options.Failure;
import urbi.USound;
import urbi.USoundSampleFormat;

/** The sound output of this machine, if it has one. */
final class Loudspeaker implements AutoCloseable {
  private @Nullable SourceDataLine line;

  /**
   * @throws Failure if there is no output
   */
  Loudspeaker() {
    if (AudioSystem.getMixerInfo().length == 0) {
      throw none("this machine has none");
    }
  }

  private static Failure none(@Nullable String why) {
    return Failure.of("no sound output (" + why + "): --output=FILE saves the sound instead");
  }

  /**
   * Plays a raw sound after those before it, which are of the same kind. Waits while too much is to
   * be played.
   *
   * @throws Failure if it cannot be played here
   */
  void play(USound raw) {
    if (line == null) {
      AudioFormat format =
          new AudioFormat(
              raw.getRate(),
              raw.getSampleSize(),
              raw.getChannels(),
              raw.getSampleFormat() != USoundSampleFormat.SAMPLE_UNSIGNED,
              false);
      try {
        line = AudioSystem.getSourceDataLine(format);
        line.open(format);
        line.start();
      } catch (LineUnavailableException | IllegalArgumentException e) {
        throw none(e.getMessage());
      }
    }
    int whole = raw.getData().length / line.getFormat().getFrameSize();
    line.write(raw.getData(), 0, whole * line.getFormat().getFrameSize());
  }

  @Override
  public void close() {
    if (line != null) {
      line.drain();
      line.close();
    }
  }
}
