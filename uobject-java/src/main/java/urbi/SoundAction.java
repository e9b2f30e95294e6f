package urbi;

/** What a {@link SoundSampler} has done. Each is called on a thread of its own but the second. */
public interface SoundAction {
  /** Begins to record. */
  void captureAudio();

  /** Ends recording. */
  void stopAudio();

  /** Plays what was recorded. */
  void playAudio();

  /** Writes what was recorded to a file. */
  void saveAudio(String path);
}
