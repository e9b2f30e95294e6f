package urbi;

import java.util.Locale;

/** How the data of a {@link USound} are to be read. */
public enum USoundFormat {
  /** Samples one after the other, those of all channels together, lowest byte first. */
  SOUND_RAW("raw"),
  /** A WAV file. */
  SOUND_WAV("wav"),
  /** An MP3 file. */
  SOUND_MP3("mp3"),
  /** An Ogg file. */
  SOUND_OGG("ogg"),
  SOUND_UNKNOWN("unknown");

  private final String text;

  USoundFormat(String text) {
    this.text = text;
  }

  /** The word that starts the header of a binary of that format. */
  public String format_string() {
    return text;
  }

  /**
   * The format that a header's first word stands for, in capitals or not; {@link #SOUND_UNKNOWN}
   * for others.
   */
  public static USoundFormat parse(String word) {
    return switch (word.toLowerCase(Locale.ROOT)) {
      case "raw" -> SOUND_RAW;
      case "wav" -> SOUND_WAV;
      case "mp3" -> SOUND_MP3;
      case "ogg" -> SOUND_OGG;
      default -> SOUND_UNKNOWN;
    };
  }
}
