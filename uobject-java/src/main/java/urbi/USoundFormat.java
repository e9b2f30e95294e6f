package urbi;

import urbi.media.SoundFormat;

/** How the data of a {@link USound} are to be read. */
public enum USoundFormat {
  /** Samples one after the other, those of all channels together, lowest byte first. */
  SOUND_RAW(SoundFormat.RAW),
  /** A WAV file. */
  SOUND_WAV(SoundFormat.WAV),
  /** An MP3 file. */
  SOUND_MP3(SoundFormat.MP3),
  /** An Ogg file. */
  SOUND_OGG(SoundFormat.OGG),
  SOUND_UNKNOWN(SoundFormat.UNKNOWN);

  private final SoundFormat format;

  USoundFormat(SoundFormat format) {
    this.format = format;
  }

  /** The word that starts the header of a binary of that format. */
  public String format_string() {
    return format.keyword();
  }

  SoundFormat format() {
    return format;
  }

  /**
   * The format that a header's first word stands for, in capitals or not; {@link #SOUND_UNKNOWN}
   * for others.
   */
  public static USoundFormat parse(String word) {
    SoundFormat wanted = SoundFormat.of(word);
    for (USoundFormat each : values()) {
      if (each.format == wanted) {
        return each;
      }
    }
    return SOUND_UNKNOWN;
  }
}
