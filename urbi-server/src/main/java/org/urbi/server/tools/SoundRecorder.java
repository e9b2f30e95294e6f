package org.urbi.server.tools;

import java.io.ByteArrayOutputStream;
import org.jspecify.annotations.Nullable;
import urbi.UConversion;
import urbi.USound;
import urbi.USoundFormat;

/** Joins consecutive sounds into one, converted to the format of the first. */
final class SoundRecorder implements AutoCloseable {
  private final @Nullable Loudspeaker loudspeaker;
  private final ByteArrayOutputStream samples = new ByteArrayOutputStream();
  private @Nullable USound first;
  private int count;

  /**
   * @param loudspeaker what plays them, or null to keep them
   */
  SoundRecorder(@Nullable Loudspeaker loudspeaker) {
    this.loudspeaker = loudspeaker;
  }

  /**
   * Adds the next sound.
   *
   * @throws urbi.UConversionException if it cannot be converted
   */
  void add(USound sound) {
    USound raw = first == null ? new USound() : like(first);
    raw.setSoundFormat(USoundFormat.SOUND_RAW);
    UConversion.convert(sound, raw);
    if (first == null) {
      first = raw;
    }
    count++;
    if (loudspeaker == null) {
      samples.writeBytes(raw.getData());
    } else {
      loudspeaker.play(raw);
    }
  }

  private static USound like(USound other) {
    USound sound = new USound();
    sound.setChannels(other.getChannels());
    sound.setRate(other.getRate());
    sound.setSampleSize(other.getSampleSize());
    sound.setSampleFormat(other.getSampleFormat());
    return sound;
  }

  /** The number of sounds. */
  int sounds() {
    return count;
  }

  /** All kept sounds as one. */
  USound sound() {
    USound all = first == null ? new USound() : like(first);
    all.setSoundFormat(USoundFormat.SOUND_RAW);
    all.setData(samples.toByteArray());
    return all;
  }

  @Override
  public void close() {
    if (loudspeaker != null) {
      loudspeaker.close();
    }
  }
}
