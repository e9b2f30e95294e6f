package urbi.media;

import java.util.Locale;

/** How the bytes of a sound are to be read. */
public enum SoundFormat {
  /** Samples one after the other, those of all channels together, lowest byte first. */
  RAW("raw"),
  /** A WAV file. */
  WAV("wav"),
  /** An MP3 file. */
  MP3("mp3"),
  /** An Ogg file. */
  OGG("ogg"),
  UNKNOWN("unknown");

  private final String keyword;

  SoundFormat(String keyword) {
    this.keyword = keyword;
  }

  /** The word that starts the header of a binary of that format. */
  public String keyword() {
    return keyword;
  }

  /** The format of a keyword, in capitals or not; {@link #UNKNOWN} for others. */
  public static SoundFormat of(String keyword) {
    return switch (keyword.toLowerCase(Locale.ROOT)) {
      case "raw" -> RAW;
      case "wav" -> WAV;
      case "mp3" -> MP3;
      case "ogg" -> OGG;
      default -> UNKNOWN;
    };
  }
}
